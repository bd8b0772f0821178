// Numbers as text into a file's buffer: the shortest that read back equal, independent of the locale.
#pragma once
#include <charconv>

#include "core/io/file.h"
#include "core/io/put_number.h"

namespace mw {

/// One line of text after the other. A line's numbers must fit the room asked for: numberRoom bytes each.
class TextOut {
public:
    explicit TextOut(OutputFile& file) : file_(file) {}

    /// Room for `numbers` numbers and 64 further bytes.
    void begin(size_t numbers)
    {
        p_ = file_.room(numberRoom * numbers + 64);
        end_ = p_ + numberRoom * numbers + 64;
    }
    /// Further room in the same line.
    void more(size_t numbers)
    {
        file_.advance(p_);
        begin(numbers);
    }
    void end()
    {
        *p_++ = '\n';
        file_.advance(p_);
    }
    /// Not longer than the room; names are written with OutputFile::write.
    void word(std::string_view text)
    {
        for (char c : text) *p_++ = c;
    }
    void put(char c) { *p_++ = c; }
    void number(float v) { p_ = putNumber(p_, v); }
    void number(uint32_t v) { p_ = putNumber(p_, v); }
    template <class T>
    void number(T v)
    {
        p_ = std::to_chars(p_, end_, v).ptr;
    }

private:
    OutputFile& file_;
    char *p_ = nullptr, *end_ = nullptr;
};

}  // namespace mw
