// Where outside test data lies. The project stands alone: without it such tests skip.
#pragma once
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace mw::test {

/// Empty when MESHWRIGHT_DATA is not set or is no folder.
inline std::filesystem::path dataFolder()
{
    const char* d = std::getenv("MESHWRIGHT_DATA");
    return d && std::filesystem::is_directory(d) ? std::filesystem::path(d) : std::filesystem::path();
}

}  // namespace mw::test

/// At the start of a test that needs outside data: declares `name` or skips.
#define MESHWRIGHT_DATA_OR_SKIP(name)                          \
    const std::filesystem::path name = mw::test::dataFolder(); \
    if (name.empty()) GTEST_SKIP() << "MESHWRIGHT_DATA is not set"
