// Files dropped on the window: on the toolbar they open, anywhere else they are added. While they are dragged the target is framed and says so.
#pragma once
#include <QObject>
#include <QStringList>
#include <QWidget>

namespace mw {

class Banner;
class FileCommands;

/// A frame of 2 pixels and a word, over whatever it is shown on.
class DropFrame : public QWidget {
    Q_OBJECT

public:
    explicit DropFrame(QWidget* parent);
    void showOn(const QRect& target, const QString& verb);
    const QString& verb() const { return verb_; }

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QString verb_;
};

class DropTarget : public QObject {
    Q_OBJECT

public:
    /// `opens` is the line of menus and tools above the view, `adds` the view.
    DropTarget(FileCommands& files, Banner& banner, QWidget* window, QWidget* opens, QWidget* adds);

signals:
    void dropped();
    void heightMapWanted(const QString& file);

protected:
    bool eventFilter(QObject* o, QEvent* e) override;

private:
    bool onBar(QPoint at) const;
    void take(const QStringList& files, bool open);
    void askAboutPicture(const QString& file);
    FileCommands& files_;
    Banner& banner_;
    QWidget *window_, *opens_, *adds_;
    DropFrame* frame_;
};

}  // namespace mw
