// What tests of drawing run on: one context for all cases of a program; after each, the driver had nothing to complain about.
#pragma once
#include <gtest/gtest.h>
#include <memory>

#include "render/offscreen.h"

namespace mw::test {

/// Draws pictures of width x height.
template <int width, int height>
class OffscreenTest : public testing::Test {
protected:
    static void SetUpTestSuite() { offscreen_ = std::make_unique<Offscreen>(true); }
    static void TearDownTestSuite() { offscreen_.reset(); }
    void TearDown() override { EXPECT_EQ(offscreen_->messages(), std::vector<std::string>{}); }
    static Picture draw(const Frame& f) { return offscreen_->draw(f, width, height); }
    static inline std::unique_ptr<Offscreen> offscreen_;
};

}  // namespace mw::test
