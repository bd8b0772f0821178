// What the list before an export says agrees with what the writers do; a selection alone keeps its place.
#include "core/io/preflight.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/scene/edit.h"
#include "core/scene/samples.h"

namespace mw {
namespace {

bool says(const std::vector<PreflightItem>& items, const std::string& words)
{
    return std::any_of(items.begin(), items.end(), [&](const PreflightItem& i) { return i.text.find(words) != std::string::npos; });
}

std::function<Mesh(MeshId)> resultsOf(const Scene& scene, Evaluator& evaluator)
{
    return [&](MeshId id) { return evaluator.evaluate(*scene.find(id)).result(); };
}

TEST(Preflight, ErrorsWhereTheWriterThrowsAndLossesWhereItWarns)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "preflight";
    std::filesystem::create_directories(folder);
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        Evaluator evaluator;
        for (const std::string ending : {".glb", ".obj", ".ply", ".off", ".stl", ".bvh", ".png"}) {
            SCOPED_TRACE(std::string(sample.id) + " to " + ending);
            WriteOptions options;
            options.evaluator = &evaluator;
            options.terrainTriangles = 2000;
            const auto items = preflight(scene, ending, options, resultsOf(scene, evaluator));
            const bool error = !items.empty() && items.front().severity == PreflightItem::Severity::Error;
            std::vector<Warning> lost;
            bool thrown = false;
            try {
                lost = writeFile(scene, folder / ("out" + ending), options);
            } catch (const Error&) {
                thrown = true;
            }
            EXPECT_EQ(error, thrown);
            for (const Warning& w : lost) {
                if (w.code == "material-lost") {
                    EXPECT_TRUE(says(items, "Materials are left out"));
                }
                if (w.code == "mesh-lost") {
                    EXPECT_TRUE(says(items, "left out: BVH"));
                }
            }
        }
    }
    std::filesystem::remove_all(folder);
}

TEST(Preflight, AnUnknownEndingIsAnError)
{
    const auto items = preflight(sampleScene("blossom"), ".doc", {}, [](MeshId) { return Mesh(); });
    ASSERT_EQ(items.size(), 1u);
    EXPECT_EQ(items[0].severity, PreflightItem::Severity::Error);
}

TEST(OnlyNodes, KeepsPlacesAndSkeletons)
{
    const Scene scene = sampleScene("mannequin");
    NodeId skinned;
    for (const NodeId n : scene.nodes())
        if (scene.node(n).skin) skinned = n;
    ASSERT_TRUE(skinned);
    const Scene part = onlyNodes(scene, {skinned});
    EXPECT_EQ(part.skins().size(), 1u);
    for (const NodeId joint : part.find(part.node(skinned).skin)->joints) {
        ASSERT_TRUE(part.find(joint));
        EXPECT_EQ(part.worldFromLocal(joint), scene.worldFromLocal(joint));
    }
    Scene two = sceneOf(scene.find(scene.meshes().front())->base, "a");
    Node child;
    child.name = "b";
    child.mesh = two.meshes().front();
    child.local.translation = {1, 2, 3};
    const NodeId b = two.add(child, two.roots().front());
    const Scene below = onlyNodes(two, {b});
    EXPECT_FALSE(below.node(below.roots().front()).mesh);
    EXPECT_EQ(below.worldFromLocal(b), two.worldFromLocal(b));
    EXPECT_EQ(amountOf(below, [&](MeshId id) { return below.find(id)->base; }).meshes, 1u);
}

TEST(PlaceImport, IsWhatReadingItSoWouldHaveGiven)
{
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "place_import.ply";
    writeFile(sampleScene("blossom"), file);
    const Imported plain = readFile(file);
    const Imported asked = readFile(file, nullptr, {.metresPerUnit = 0.01, .up = UpAxis::Z});
    const EditCall call{"place-import",
                        {{"nodes", nodeText(plain.scene, plain.scene.roots())}, {"from-unit", 1.0}, {"from-up", "y"}, {"unit", 0.01}, {"up", "z"}}};
    const Scene placed = edited(plain.scene, call);
    const glm::dmat4 a = placed.worldFromLocal(placed.roots().front()), b = asked.scene.worldFromLocal(asked.scene.roots().front());
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) EXPECT_NEAR(a[c][r], b[c][r], 1e-12);
    EXPECT_EQ(contentHash(edited(plain.scene, parsedEdit(commandText(call)))), contentHash(placed));
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace mw
