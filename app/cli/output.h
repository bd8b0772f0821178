// What verbs share for speaking: numbers, JSON, warnings, and the bar for long work.
#pragma once
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "core/error.h"
#include "core/steps/progress.h"

namespace mw::cli {

/// Six digits at most, never a comma: "0.156", "1.2e-07"; "undefined" when not finite.
std::string shown(double v);
/// "1 face", "2 faces".
std::string counted(size_t n, const char* one, const char* many = nullptr);
/// One line on standard output. Text that is no UTF-8 (file names may hold anything) is mended, numbers that are not finite become null.
void printJson(const nlohmann::json& j);
/// To standard error, as `meshwright: FILE: warning: TEXT`.
void warn(const std::string& file, std::span<const Warning> warnings);
/// The number, or null when it is not finite.
nlohmann::json finite(double v);

/// While it lives: a bar on standard error when that is a terminal and the work lasts; an interrupt (Ctrl-C) cancels the work
/// cleanly, a second one ends the process.
class Working {
public:
    explicit Working(std::string what);
    ~Working();
    Working(const Working&) = delete;
    Working& operator=(const Working&) = delete;
    Progress* progress();
    /// The next part of the work.
    void now(std::string what);

private:
    struct Bar;
    std::unique_ptr<Bar> bar_;
};

}  // namespace mw::cli
