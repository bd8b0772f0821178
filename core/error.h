// The one error type, and the warnings that come beside a usable result. Texts are for people: what, where, what to do.
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace mw {

/// Something from outside could not be used. `reason` names the place and the remedy ("line 12: a face uses vertex 99 of 4; check the
/// exporter"), `file` the file, empty when none is concerned. what() is "FILE: REASON".
class Error : public std::runtime_error {
public:
    explicit Error(std::string reason) : Error({}, std::move(reason)) {}
    Error(std::string file, std::string reason)
        : std::runtime_error(file.empty() ? reason : file + ": " + reason), file_(std::move(file)), reason_(std::move(reason))
    {}
    const std::string& file() const { return file_; }
    const std::string& reason() const { return reason_; }

private:
    std::string file_, reason_;
};

/// Thrown by long work when its Progress was cancelled. Not an error: nobody is told.
struct Cancelled {};

/// Something odd that was kept or mended. `code` is a short stable name for scripts ("nan-position").
struct Warning {
    std::string code, text;
    std::vector<uint32_t> elements;  ///< payload indices of what is concerned (of the kind the text says), possibly cut short
};

}  // namespace mw
