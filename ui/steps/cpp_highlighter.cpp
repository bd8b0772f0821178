// See cpp_highlighter.h.
#include "ui/steps/cpp_highlighter.h"

#include <QSet>

#include "ui/look.h"

namespace mw {

namespace {

const QSet<QString>& keywords()
{
    static const QSet<QString> words{"alignas",   "auto",     "bool",     "break",     "case",      "catch",    "char",      "class",    "co_await",
                                     "co_return", "co_yield", "const",    "consteval", "constexpr", "continue", "decltype",  "default",  "delete",
                                     "do",        "double",   "else",     "enum",      "explicit",  "extern",   "false",     "final",    "float",
                                     "for",       "if",       "inline",   "int",       "long",      "mutable",  "namespace", "new",      "noexcept",
                                     "nullptr",   "operator", "override", "private",   "protected", "public",   "return",    "short",    "signed",
                                     "sizeof",    "static",   "struct",   "switch",    "template",  "this",     "throw",     "true",     "try",
                                     "typename",  "unsigned", "using",    "virtual",   "void",      "while",    "concept",   "requires", "int64_t",
                                     "uint8_t",   "uint32_t", "uint64_t", "size_t"};
    return words;
}

struct Colours {
    QColor keyword, comment, string, number;
};

Colours colours()
{
    if (look::dark()) return {"#C9A5F7", "#8F9AA5", "#8FCBA0", "#F0B27A"};
    return {"#6F35B5", "#5A6672", "#1D6B3C", "#8A4B08"};
}

}  // namespace

void CppHighlighter::highlightBlock(const QString& text)
{
    enum { Code = 0, InComment = 1 };
    setCurrentBlockState(Code);
    qsizetype i = 0;
    if (previousBlockState() == InComment) i = comment(text, 0);
    while (i < text.size()) {
        const QChar c = text[i];
        if (c == '/' && i + 1 < text.size() && text[i + 1] == '/') {
            setFormat(int(i), int(text.size() - i), colours().comment);
            return;
        }
        if (c == '/' && i + 1 < text.size() && text[i + 1] == '*')
            i = comment(text, i);
        else if (c == '"' || c == '\'')
            i = string(text, i);
        else if (c.isLetterOrNumber() || c == '_')
            i = word(text, i);
        else if (c == '#') {
            setFormat(int(i), int(text.size() - i), colours().keyword);
            return;
        } else
            ++i;
    }
}

// Up to its end, or over the line: then the next line goes on with it.
qsizetype CppHighlighter::comment(const QString& text, qsizetype from)
{
    const qsizetype end = text.indexOf("*/", from);
    const qsizetype to = end < 0 ? text.size() : end + 2;
    if (end < 0) setCurrentBlockState(1);
    setFormat(int(from), int(to - from), colours().comment);
    return to;
}

qsizetype CppHighlighter::string(const QString& text, qsizetype from)
{
    qsizetype to = from + 1;
    while (to < text.size() && text[to] != text[from]) to += text[to] == '\\' ? 2 : 1;
    to = std::min(to + 1, text.size());
    setFormat(int(from), int(to - from), colours().string);
    return to;
}

qsizetype CppHighlighter::word(const QString& text, qsizetype from)
{
    const bool number = text[from].isDigit();
    qsizetype to = from;
    while (to < text.size()) {
        const QChar c = text[to];
        const bool exponentSign = number && (c == '-' || c == '+') && (text[to - 1] == 'e' || text[to - 1] == 'E');
        const bool digitMark = number && (c == '.' || (c == '\'' && to + 1 < text.size() && text[to + 1].isDigit()));
        if (!c.isLetterOrNumber() && c != '_' && !exponentSign && !digitMark) break;
        ++to;
    }
    if (number)
        setFormat(int(from), int(to - from), colours().number);
    else if (keywords().contains(text.mid(from, to - from)))
        setFormat(int(from), int(to - from), colours().keyword);
    return to;
}

}  // namespace mw
