// What becomes of the editor when the program that reads foreign files misbehaves: small scripts stand in for it.
#include "core/io/foreign.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "core/io/gltf.h"

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

class Foreign : public ::testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() / ("meshwright-foreign-" + std::to_string(getpid()));
        fs::create_directories(folder_);
        std::ofstream(file()) << "anything";
        setenv("MESHWRIGHT_IMPORT", (folder_ / "importer").c_str(), 1);
    }
    void TearDown() override
    {
        unsetenv("MESHWRIGHT_IMPORT");
        unsetenv("MESHWRIGHT_IMPORT_SECONDS");
        fs::remove_all(folder_);
    }
    fs::path file() const { return folder_ / "model.fbx"; }
    void importerDoes(const std::string& script)
    {
        std::ofstream(folder_ / "importer") << "#!/bin/sh\n" << script << '\n';
        fs::permissions(folder_ / "importer", fs::perms::owner_all);
    }
    /// The message; it names the file and nothing is left running.
    std::string refusal()
    {
        try {
            mw::readForeign(file());
        } catch (const mw::Error& e) {
            EXPECT_TRUE(std::string(e.what()).starts_with(file().string() + ": ")) << e.what();
            EXPECT_EQ(e.file(), file().string());
            EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child was left behind";
            return e.reason();
        }
        return "it was read";
    }
    fs::path folder_;
};

TEST_F(Foreign, ResultIsReadWithFormatUnitsAndWarnings)
{
    const mw::Scene scene =
        mw::sceneOf(mw::Mesh::triangles(mw::Array<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, mw::Array<uint32_t>{0, 1, 2}), "piece");
    mw::writeGltf(scene, folder_ / "result.glb", {.project = true});
    importerDoes(
        "cat " + (folder_ / "result.glb").string() +
        R"(; echo noise >&2; echo '{"format":"F 1","units":"centimetres","metresPerUnit":0.01,"up":"z","placementFromFile":true,"warnings":[{"code":"c","text":"t"}]}' >&2)");
    const mw::Imported in = mw::readForeign(file());
    EXPECT_EQ(in.format, "F 1");
    EXPECT_EQ(in.units, "centimetres");
    EXPECT_EQ(in.placement, (mw::Placement{0.01, mw::UpAxis::Z}));
    EXPECT_TRUE(in.placementFromFile);
    EXPECT_FALSE(in.project);
    ASSERT_EQ(in.warnings.size(), 1u);
    EXPECT_EQ(in.warnings[0].code, "c");
    EXPECT_EQ(contentHash(in.scene), contentHash(scene));
}

TEST_F(Foreign, EveryEndIsAMessage)
{
    for (const char* signal : {"SEGV", "ABRT", "BUS", "FPE"}) {
        importerDoes(std::string("kill -") + signal + " $$");
        EXPECT_NE(refusal().find("memory error"), std::string::npos) << signal;
    }
    importerDoes("kill -XCPU $$");
    EXPECT_NE(refusal().find("too long"), std::string::npos);
    importerDoes("kill -KILL $$");
    EXPECT_NE(refusal().find("from outside"), std::string::npos);
    importerDoes("exit 3");
    EXPECT_NE(refusal().find("more memory"), std::string::npos);
    importerDoes(R"(echo '{"error":"line 7: odd"}' >&2; exit 1)");
    EXPECT_EQ(refusal(), "line 7: odd");
    importerDoes("exit 9");
    EXPECT_NE(refusal().find("status 9"), std::string::npos);
    importerDoes("echo not a GLB");
    EXPECT_GT(refusal().size(), 20u);
    importerDoes("true");
    EXPECT_GT(refusal().size(), 20u);
}

TEST_F(Foreign, OutputHasABound)
{
    importerDoes("exec cat /dev/zero >&2");
    EXPECT_NE(refusal().find("MiB"), std::string::npos);
}

TEST_F(Foreign, NoImporter)
{
    EXPECT_NE(refusal().find("install meshwright again"), std::string::npos);
    unsetenv("MESHWRIGHT_IMPORT");
    fs::remove(file());
    EXPECT_NE(refusal(), "it was read");
}

TEST_F(Foreign, WaitHasAnEnd)
{
    setenv("MESHWRIGHT_IMPORT_SECONDS", "1", 1);
    importerDoes("exec sleep 60");
    const auto start = std::chrono::steady_clock::now();
    EXPECT_NE(refusal().find("longer than 2 s"), std::string::npos);
    EXPECT_LT(std::chrono::steady_clock::now() - start, 6s);
}

// A closed pipe is no end: the program may go on for ever.
TEST_F(Foreign, SilenceIsNoEnd)
{
    setenv("MESHWRIGHT_IMPORT_SECONDS", "1", 1);
    importerDoes("exec sleep 60 >&- 2>&-");
    EXPECT_NE(refusal().find("longer than 2 s"), std::string::npos);
}

TEST_F(Foreign, CancelEndsItAndItsChildren)
{
    const fs::path pids = folder_ / "pids";
    importerDoes("sleep 60 & echo $! $$ > " + pids.string() + "; wait");
    mw::Progress progress;
    std::chrono::steady_clock::time_point asked;
    std::thread impatient([&] {
        while (!fs::exists(pids) || fs::file_size(pids) == 0) std::this_thread::sleep_for(5ms);
        asked = std::chrono::steady_clock::now();
        progress.cancelled = true;
    });
    EXPECT_THROW(mw::readForeign(file(), &progress), mw::Cancelled);
    const auto ended = std::chrono::steady_clock::now();
    impatient.join();
    EXPECT_LT(ended - asked, 100ms);
    int grandchild = 0, child = 0;
    std::ifstream(pids) >> grandchild >> child;
    ASSERT_GT(child, 0);
    EXPECT_EQ(kill(child, 0), -1);
    // The orphan is reaped by somebody else; it is dead at any rate.
    std::this_thread::sleep_for(50ms);
    std::ifstream stat("/proc/" + std::to_string(grandchild) + "/stat");
    std::string number, name, state;
    if (stat >> number >> name >> state) {
        EXPECT_EQ(state, "Z");
    }
}

}  // namespace
