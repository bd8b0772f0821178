// The list of edits: what a call changes, its text, and what it says when it cannot.
#include "core/scene/edit.h"

#include <gtest/gtest.h>

namespace mw {
namespace {

Document twoNodes()
{
    Scene s;
    for (const char* name : {"bunny", "box"}) {
        Node n;
        n.name = name;
        s.add(n);
    }
    Document d;
    d.open(std::move(s), {}, "Open");
    return d;
}

TEST(Edit, RunsAndIsOneHistoryEntryWithItsCommand)
{
    Document d = twoNodes();
    const EditCall call = parsedEdit("transform:node=bunny,position=0/1/0.5,scale=2/2/2");
    commitEdit(d, call);
    EXPECT_EQ(d.scene().node(nodeOf(d.scene(), "bunny")).local.translation, glm::dvec3(0, 1, 0.5));
    ASSERT_EQ(d.history().size(), 2u);
    EXPECT_EQ(d.history()[1].calls, std::vector{call});
    EXPECT_EQ(parsedEdit(commandText(call)), call);
    EXPECT_EQ(d.undoName(), "bunny: transform");
    commitEdit(d, call);  // nothing changes
    EXPECT_EQ(d.history().size(), 2u);
}

TEST(Edit, NamesNodesAloneOrByNumber)
{
    Scene s = twoNodes().scene();
    const auto nodes = s.nodes();
    EXPECT_EQ(nodeText(s, nodes), "bunny+box");
    EXPECT_EQ(nodesOf(s, "box+bunny+box"), (std::vector<NodeId>{nodes[1], nodes[0]}));
    Node twin = s.node(nodes[0]);
    s.add(twin);
    EXPECT_EQ(nodesOf(s, nodeText(s, s.nodes())), s.nodes());
    for (const char* wrong : {"", "lamp", "#999", "#", "bunny"}) {
        EXPECT_THROW(nodesOf(s, wrong), Error) << wrong;
    }
    EXPECT_THROW(parsedEdit("explode:node=box"), Error);
}

}  // namespace
}  // namespace mw
