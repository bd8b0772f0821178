// The history as a command line: what is said, and that a shell reads it as it was meant.
#include "core/scene/command_line.h"

#include <array>
#include <cstdio>
#include <gtest/gtest.h>

#include "core/io/io.h"

namespace mw {
namespace {

// What a shell makes of a word.
std::string echoed(const std::string& word)
{
    FILE* shell = popen(("printf %s " + shellQuoted(word)).c_str(), "r");
    std::string out;
    for (int c; (c = fgetc(shell)) != EOF;) out += char(c);
    pclose(shell);
    return out;
}

TEST(CommandLine, WordsReachTheShellAsTheyAre)
{
    for (const char* word :
         {"plain.obj", "two words", "it's", "$HOME `ls` \"x\"", "a\\b", "new\nline", "*", "~", "''", "l\u00e9g\u00e8re", "a;b|c>d", "#1"}) {
        EXPECT_EQ(echoed(word), word);
    }
    EXPECT_EQ(shellQuoted("bunny.obj"), "bunny.obj");
    EXPECT_EQ(shellQuoted("it's"), "'it'\\''s'");
    EXPECT_EQ(shellQuoted(""), "''");
}

Document opened(const char* file)
{
    Scene s = sceneOf(std::get<Mesh>(apply(operation("icosphere"), {}, {})), "bunny");
    Document d;
    d.open(std::move(s), file, "Open");
    return d;
}

TEST(CommandLine, SaysModifiersShortAndEverythingElseAsEdits)
{
    Document d = opened("bunny.obj");
    commitEdit(d, parsedEdit("modify:node=bunny,op=weld"));
    commitEdit(d, parsedEdit("modify:node=bunny,op=decimate-quadric,with=\"stop=faces,faces=200\""));
    EXPECT_EQ(commandLine(d, 1), "meshwright process bunny.obj --op weld -o result.glb");
    EXPECT_EQ(commandLine(d, 2).substr(0, 54), "meshwright process bunny.obj --op weld --op decimate-q");
    EXPECT_EQ(callsUpTo(d, 2).size(), 2u);
    commitEdit(d, parsedEdit("rename:node=bunny,name=it's"));
    const std::string line = commandLine(d, 3);
    EXPECT_NE(line.find(" --do modify:node=bunny,op=weld "), std::string::npos) << line;
    EXPECT_NE(line.find(R"( --do 'rename:node=bunny,name=it'\''s' )"), std::string::npos) << line;
    EXPECT_EQ(entryCommand(d, 3), R"(meshwright process bunny.obj --do 'rename:node=bunny,name=it'\''s' -o result.glb)");
    EXPECT_EQ(callCommand(d, parsedEdit("delete:nodes=bunny")), "meshwright process bunny.obj --do delete:nodes=bunny -o result.glb");
}

TEST(CommandLine, SaysWhatCannotBeRepeated)
{
    Document d = opened("bunny.obj");
    commitEdit(d, parsedEdit("modify:node=bunny,op=weld"));
    Scene s = d.scene();
    s.add(Node{});
    d.commit("By hand", s);
    EXPECT_NO_THROW(commandLine(d, 1));
    try {
        commandLine(d, 2);
        FAIL();
    } catch (const Error& e) {
        EXPECT_STREQ(e.what(), "\"By hand\" cannot be repeated from a command line");
    }
    Document unknown;
    unknown.open(Scene(), {}, "Made");
    EXPECT_THROW(commandLine(unknown, 0), Error);
    EXPECT_EQ(commandLine(Document(), 0), "meshwright process - -o result.glb");
}

TEST(CommandLine, BeginsAnewWhenTheSourceIsOverwritten)
{
    Document d = opened("bunny.glb");
    commitEdit(d, parsedEdit("modify:node=bunny,op=weld"));
    d.saved("other.glb");
    EXPECT_EQ(callsUpTo(d, 1).size(), 1u) << "saved under another name: the source is as it was";
    d.saved("bunny.glb");
    EXPECT_EQ(callsUpTo(d, 1).size(), 0u);
    commitEdit(d, parsedEdit("show:nodes=bunny,visible=false"));
    EXPECT_EQ(commandLine(d, 2), "meshwright process bunny.glb --do show:nodes=bunny,visible=false -o result.glb");
    EXPECT_THROW(callsUpTo(d, 0), Error);
}

}  // namespace
}  // namespace mw
