// The source file of the running algorithm, at the line that runs.
#pragma once
#include <QPlainTextEdit>
#include <vector>

#include "ui/session.h"

namespace mw {

QWidget* makeSourcePanel(Session& session, QWidget* parent);

/// Where a statement with a co_yield begins and ends: lines count from 1.
struct YieldLines {
    unsigned first, last;
};
std::vector<YieldLines> yieldsIn(const QString& source);

/// Read-only C++ text with line numbers and one running statement.
class SourceView : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit SourceView(QWidget* parent = nullptr);
    void setSource(const QString& text);
    /// Marks the statement the line belongs to and keeps it in the middle third; 0: none.
    void setRunning(unsigned line);
    unsigned runningLine() const { return running_; }
    /// Where the running statement begins: g++ names the last line of a co_yield over several.
    unsigned runningFirstLine() const;
    void paintGutter(QPaintEvent* e);
    int gutterWidth() const;

signals:
    void yieldClicked(unsigned firstLine, unsigned lastLine);

protected:
    void resizeEvent(QResizeEvent* e) override;
    void mouseMoveEvent(QMouseEvent* e) override;
    void mouseReleaseEvent(QMouseEvent* e) override;
    void changeEvent(QEvent* e) override;

private:
    const YieldLines* yieldAt(unsigned line) const;
    void mark();
    void keepInMiddle(int line);
    QWidget* gutter_;
    std::vector<YieldLines> yields_;
    unsigned running_ = 0;
};

}  // namespace mw
