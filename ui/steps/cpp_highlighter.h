// Colours of C++ text: keywords, comments, strings, numbers.
#pragma once
#include <QSyntaxHighlighter>

namespace mw {

class CppHighlighter : public QSyntaxHighlighter {
    Q_OBJECT

public:
    using QSyntaxHighlighter::QSyntaxHighlighter;

protected:
    void highlightBlock(const QString& text) override;

private:
    qsizetype comment(const QString& text, qsizetype from);
    qsizetype string(const QString& text, qsizetype from);
    qsizetype word(const QString& text, qsizetype from);
};

}  // namespace mw
