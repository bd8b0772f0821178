// Units and axes: words for them, what files state, what overrules it, and where a scene stands afterwards.
#include "core/io/placement.h"

#include <cmath>

#include "core/scene/scene_pose.h"

#include "helpers.h"

namespace mw::test {
namespace {

TEST(Placement, UnitsHaveManyNames)
{
    for (const char* mm : {"mm", "MM", "millimeters", "Millimetre", "0.001", "1e-3", "1e-3 m", "1 mm", "0.1cm"})
        EXPECT_NEAR(metresOf(mm).value_or(0), 0.001, 1e-18) << mm;
    EXPECT_EQ(metresOf("in"), 0.0254);
    EXPECT_EQ(metresOf("inches"), 0.0254);
    EXPECT_EQ(metresOf("feet"), 0.3048);
    EXPECT_EQ(metresOf("m"), 1);
    for (const char* wrong : {"", "0", "-1", "nan", "inf", "parsec", "1 parsec", "mm mm", "1e999"}) EXPECT_FALSE(metresOf(wrong)) << wrong;
    EXPECT_EQ(unitText(0.01), "centimetres");
    EXPECT_EQ(unitText(0.0254), "inches");
    EXPECT_EQ(unitText(0.3), "units of 0.3 m");
    for (const char* z : {"z", "Z", "+z", "Z_UP", "z-up", "Z up"}) EXPECT_EQ(upAxisOf(z), UpAxis::Z) << z;
    for (const char* wrong : {"", "w", "-z", "up", "zz"}) EXPECT_FALSE(upAxisOf(wrong)) << wrong;
}

TEST(Placement, CommentsAreTakenOnlyWhenTheySayItClearly)
{
    const auto heard = [](const char* comment) {
        Stated s;
        s.listen(comment);
        return s;
    };
    EXPECT_EQ(heard(" units: mm").metresPerUnit, 0.001);
    EXPECT_EQ(heard("Units = centimeters").metresPerUnit, 0.01);
    EXPECT_EQ(heard(" File Units: Inches").metresPerUnit, 0.0254);
    EXPECT_EQ(heard("UNITS=mm").metresPerUnit, 0.001);
    EXPECT_EQ(heard("up axis: Z").up, UpAxis::Z);
    EXPECT_EQ(heard("up = y").up, UpAxis::Y);
    EXPECT_EQ(heard(" Z-up").up, UpAxis::Z);
    EXPECT_EQ(heard("units: feet, up: x").up, UpAxis::X);
    EXPECT_EQ(heard("units: feet, up: x").metresPerUnit, 0.3048);
    for (const char* nothing :
         {"unit 3", "unit: 3", "12 units", "made in Y", "pick up x", "units", "up", "a unit cube: m", "units: large", "community: m"}) {
        EXPECT_FALSE(heard(nothing).metresPerUnit) << nothing;
        EXPECT_FALSE(heard(nothing).up) << nothing;
    }
    for (const Placement p : {Placement{}, Placement{0.001, UpAxis::Z}, Placement{0.3, UpAxis::X}}) {
        const Stated s = heard(statement(p).c_str());
        EXPECT_EQ(s.metresPerUnit, p.metresPerUnit) << statement(p);
        EXPECT_EQ(s.up, p.up);
    }
}

TEST(Placement, MatricesAreInverseAndKeepHandedness)
{
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z, UpAxis::X}) {
        const Placement p{0.5, up};
        EXPECT_EQ(sceneFromFile(p) * fileFromScene(p), glm::dmat4(1));
        EXPECT_EQ(glm::determinant(glm::dmat3(sceneFromFile(p))), 0.125);
        const glm::dvec4 upward(up == UpAxis::X, up == UpAxis::Y, up == UpAxis::Z, 0);
        EXPECT_EQ(sceneFromFile(p) * upward, glm::dvec4(0, 0.5, 0, 0));
    }
}

glm::dvec3 placeOf(const Imported& in, size_t vertex)
{
    const NodeId node = in.scene.nodes().back();
    return glm::dvec3(in.scene.worldFromLocal(node) * glm::dvec4(glm::dvec3(meshOf(in).positions()[vertex]), 1));
}

TEST(Placement, WhatTheFileStatesIsTakenAndCanBeOverruled)
{
    const Folder folder;
    const std::string body = "v 0 0 0\nv 1000 0 0\nv 0 0 2000\nf 1 2 3\n";
    const auto file = folder.write("a.obj", "# by somebody\n# Units: mm\n# up: z\n" + body);
    const Imported stated = readFile(file);
    EXPECT_EQ(stated.units, "millimetres");
    EXPECT_TRUE(stated.placementFromFile);
    EXPECT_EQ(stated.placement, (Placement{0.001, UpAxis::Z}));
    EXPECT_LT(glm::distance(placeOf(stated, 2), glm::dvec3(0, 2, 0)), 1e-12);
    EXPECT_EQ(meshOf(stated).positions()[2], glm::vec3(0, 0, 2000));  // the numbers themselves stay
    const Imported asked = readFile(file, nullptr, {0.01, UpAxis::Y});
    EXPECT_LT(glm::distance(placeOf(asked, 2), glm::dvec3(0, 0, 20)), 1e-12);
    EXPECT_EQ(asked.units, "centimetres");
    EXPECT_FALSE(asked.placementFromFile);
    const Imported silent = readFile(folder.write("b.obj", body));
    EXPECT_EQ(silent.units, "unknown");
    EXPECT_EQ(silent.placement, Placement{});
    EXPECT_FALSE(silent.placementFromFile);
    const Imported ply = readFile(folder.write("a.ply",
                                               "ply\nformat ascii 1.0\ncomment Units: inches\nelement vertex 1\nproperty float x\nproperty "
                                               "float y\nproperty float z\nend_header\n1 0 0\n"));
    EXPECT_EQ(ply.placement.metresPerUnit, 0.0254);
    const Imported off = readFile(folder.write("a.off", "OFF # file units = ft\n1 0 0\n1 0 0\n"));
    EXPECT_EQ(off.placement.metresPerUnit, 0.3048);
    std::string stl = "exported by x, UNITS=mm";
    stl.resize(80, ' ');
    stl += std::string("\1\0\0\0", 4) + std::string(50, '\0');
    EXPECT_EQ(readFile(folder.write("a.stl", stl)).placement.metresPerUnit, 0.001);
}

TEST(Placement, ImplausibleSizesAreDoubtedOnlyWhenNobodySaidTheUnit)
{
    const Folder folder;
    const auto sized = [&](const char* size, const char* comment) {
        return folder.write("a.obj", std::string(comment) + "v 0 0 0\nv " + size + " 0 0\nv 0 0.0001 0\nf 1 2 3\n");
    };
    EXPECT_TRUE(warning(readFile(sized("150", "")).warnings, "unit-guess"));
    EXPECT_NE(warning(readFile(sized("150", "")).warnings, "unit-guess")->text.find("millimetres?"), std::string::npos);
    EXPECT_TRUE(warning(readFile(sized("0.0005", "")).warnings, "unit-guess"));
    EXPECT_FALSE(warning(readFile(sized("99", "")).warnings, "unit-guess"));
    EXPECT_FALSE(warning(readFile(sized("0.01", "")).warnings, "unit-guess"));
    EXPECT_FALSE(warning(readFile(sized("150", "# units: m\n")).warnings, "unit-guess"));
    EXPECT_FALSE(warning(readFile(sized("150", ""), nullptr, {1, {}}).warnings, "unit-guess"));
    EXPECT_FALSE(warning(readFile(sized("150000", ""), nullptr, {0.001, {}}).warnings, "unit-guess"));
}

TEST(Placement, UnitsOutOfAllBoundsAreRefused)
{
    const Folder folder;
    const auto file = folder.write("a.obj", "v 0 0 0\n");
    for (const double wrong : {0.0, -1.0, std::nan(""), 1e300}) {
        EXPECT_NE(errorOf([&] { readFile(file, nullptr, {wrong, {}}); }).find("unit"), std::string::npos);
        EXPECT_NE(errorOf([&] {
                      writeFile(readFile(file).scene, folder.path / "b.obj", {.placement = {wrong, UpAxis::Y}});
                  }).find("unit"),
                  std::string::npos);
    }
}

/// A clip replaces the root's own transform: the unit must hold while it plays.
TEST(Placement, HoldsWhileARootMoves)
{
    const Folder folder;
    const auto file =
        folder.write("a.bvh",
                     "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 3 Xposition Yposition Zposition\n End Site\n {\n  OFFSET 0 100 0\n "
                     "}\n}\nMOTION\nFrames: 2\nFrame Time: 0.1\n0 0 0\n0 0 300\n");
    const auto rootAt = [](const Imported& in, double time) {
        const Scene& s = in.scene;
        const ScenePose pose = poseAt(s, *s.find(s.clips().at(0)), time);
        const auto worlds = worldMatrices(s, pose);
        for (const NodeId id : s.nodes())
            if (s.node(id).name == "Hips") return glm::dvec3(worlds.at(id)[3]);
        return glm::dvec3(-1);
    };
    EXPECT_LT(glm::distance(rootAt(readFile(file), 0.1), glm::dvec3(0, 0, 300)), 1e-12);
    EXPECT_LT(glm::distance(rootAt(readFile(file, nullptr, {0.01, UpAxis::Z}), 0.1), glm::dvec3(0, 3, 0)), 1e-12);
    // Back again, with the root it had.
    Imported in = readFile(file, nullptr, {0.01, UpAxis::Z});
    placeAgain(in.scene, in.scene.roots(), in.placement, {});
    EXPECT_LT(glm::distance(rootAt(in, 0.1), glm::dvec3(0, 0, 300)), 1e-9);
}

}  // namespace
}  // namespace mw::test
