// MD5 is trusted blindly by Assimp: counts and indices that lie make it crash or give nonsense. So they are compared here first.
#include <charconv>

#include "app/importer/conversion.h"

namespace mw {

namespace {

class Md5Check {
public:
    explicit Md5Check(std::string_view content) : rest_(content) { next(); }
    void mesh();
    void animation();

private:
    void next();
    void skipLine() { rest_.remove_prefix(std::min(rest_.size(), rest_.find('\n') == rest_.npos ? rest_.size() : rest_.find('\n'))); }
    int64_t number(const char* what);
    int64_t count(const char* what, size_t leastBytes);
    void expect(std::string_view word);
    void skipBlock();
    void numbers(int n)
    {
        for (int i = 0; i < n; ++i) {
            if (token_ == "(" || token_ == ")") fail("numbers expected");
            next();
        }
    }
    void joints(int64_t count);
    void meshBlock(int64_t joints);
    [[noreturn]] void fail(const std::string& what) const
    {
        throw Error("line " + std::to_string(line_) + ": " + what + "; the file is damaged, export it again");
    }
    void within(int64_t value, int64_t from, int64_t below, const char* what) const
    {
        if (value < from || value >= below)
            fail(std::string(what) + " " + std::to_string(value) + (below > 0 ? " of " + std::to_string(below) : ", but there are none"));
    }

    std::string_view rest_, token_;
    size_t line_ = 1;
};

void Md5Check::next()
{
    for (;;) {
        while (!rest_.empty() && uint8_t(rest_[0]) <= ' ') {
            line_ += rest_[0] == '\n';
            rest_.remove_prefix(1);
        }
        if (!rest_.starts_with("//")) break;
        skipLine();
    }
    size_t n = 0;
    if (rest_.starts_with('"'))
        n = std::min(rest_.find('"', 1), rest_.size() - 1) + 1;
    else if (!rest_.empty() && std::string_view("(){}").find(rest_[0]) != std::string_view::npos)
        n = 1;
    else
        while (n < rest_.size() && uint8_t(rest_[n]) > ' ' && std::string_view("(){}").find(rest_[n]) == std::string_view::npos) ++n;
    token_ = rest_.substr(0, n);
    rest_.remove_prefix(n);
}

int64_t Md5Check::number(const char* what)
{
    int64_t value = 0;
    const auto [end, error] = std::from_chars(token_.data(), token_.data() + token_.size(), value);
    if (error != std::errc() || end != token_.data() + token_.size()) fail(std::string("the ") + what + " is no whole number");
    next();
    return value;
}

/// Of things that take some bytes each in the rest of the file.
int64_t Md5Check::count(const char* what, size_t leastBytes)
{
    const int64_t n = number(what);
    if (n < 0 || uint64_t(n) * leastBytes > rest_.size() + 64)
        fail(std::string(what) + " is " + std::to_string(n) + ", but the file is too short for so many");
    return n;
}

void Md5Check::expect(std::string_view word)
{
    if (token_ != word) fail("\"" + std::string(word) + "\" expected" + (token_.empty() ? ", but the file ends" : ""));
    next();
}

void Md5Check::skipBlock()
{
    expect("{");
    while (!token_.empty() && token_ != "}") next();
    expect("}");
}

void Md5Check::joints(int64_t expected)
{
    expect("{");
    int64_t found = 0;
    for (; token_ != "}" && !token_.empty(); ++found) {
        next();
        within(number("parent of a joint"), -1, found, "parent of a joint: joint");
        expect("("), numbers(3), expect(")"), expect("("), numbers(3), expect(")");
    }
    expect("}");
    if (found != expected) fail("numJoints is " + std::to_string(expected) + ", but there are " + std::to_string(found));
}

void Md5Check::meshBlock(int64_t joints)
{
    expect("{");
    int64_t vertices = 0, weights = 0, triangles = 0, lastWeight = 0;
    while (token_ != "}" && !token_.empty()) {
        const std::string_view key = token_;
        next();
        if (key == "numverts") {
            vertices = count("numverts", 12);
        } else if (key == "numtris") {
            triangles = count("numtris", 10);
        } else if (key == "numweights") {
            weights = count("numweights", 16);
        } else if (key == "vert") {
            within(number("index of a vertex"), 0, vertices, "vertex");
            expect("("), numbers(2), expect(")");
            const int64_t first = number("first weight of a vertex"), n = number("number of weights of a vertex");
            if (first < 0 || n < 0 || n > 4096 || first > int64_t(1) << 32) fail("the weights of a vertex cannot be");
            lastWeight = std::max(lastWeight, first + n);
        } else if (key == "tri") {
            within(number("index of a triangle"), 0, triangles, "triangle");
            for (int i = 0; i < 3; ++i) within(number("vertex of a triangle"), 0, vertices, "a triangle uses vertex");
        } else if (key == "weight") {
            within(number("index of a weight"), 0, weights, "weight");
            within(number("joint of a weight"), 0, joints, "a weight is of joint");
            numbers(1), expect("("), numbers(3), expect(")");
        } else {
            next();  // shader "name"
        }
    }
    expect("}");
    if (lastWeight > weights) fail("a vertex uses weight " + std::to_string(lastWeight - 1) + " of " + std::to_string(weights));
}

void Md5Check::mesh()
{
    int64_t jointCount = 0, meshCount = 0, meshes = 0;
    while (!token_.empty()) {
        const std::string_view key = token_;
        next();
        if (key == "numJoints") {
            jointCount = count("numJoints", 16);
        } else if (key == "numMeshes") {
            meshCount = count("numMeshes", 8);
        } else if (key == "joints") {
            joints(jointCount);
        } else if (key == "mesh") {
            meshBlock(jointCount);
            ++meshes;
        } else {
            next();
        }
    }
    if (meshes != meshCount) fail("numMeshes is " + std::to_string(meshCount) + ", but there are " + std::to_string(meshes));
    if (meshes == 0) fail("there is no mesh in it");
}

void Md5Check::animation()
{
    int64_t frames = 0, jointCount = 0, components = 0, found = 0;
    while (!token_.empty()) {
        const std::string_view key = token_;
        next();
        if (key == "numFrames") {
            frames = count("numFrames", 8);
        } else if (key == "numJoints") {
            jointCount = count("numJoints", 8);
        } else if (key == "numAnimatedComponents") {
            components = number("numAnimatedComponents");
            within(components, 0, 6 * jointCount + 1, "numAnimatedComponents");
        } else if (key == "hierarchy") {
            expect("{");
            int64_t joint = 0;
            for (; token_ != "}" && !token_.empty(); ++joint) {
                next();
                within(number("parent of a joint"), -1, std::max<int64_t>(joint, 0), "parent of a joint: joint");
                const int64_t flags = number("flags of a joint"), first = number("first component of a joint");
                int64_t used = 0;
                for (int bit = 0; bit < 6; ++bit) used += flags >> bit & 1;
                if (used) within(first + used - 1, 0, components, "a joint uses component");
            }
            expect("}");
            if (joint != jointCount) fail("numJoints is " + std::to_string(jointCount) + ", but there are " + std::to_string(joint));
        } else if (key == "frame") {
            within(number("index of a frame"), 0, frames, "frame");
            expect("{");
            int64_t n = 0;
            for (; token_ != "}" && !token_.empty(); ++n) next();
            expect("}");
            if (n < components) fail("a frame has " + std::to_string(n) + " of " + std::to_string(components) + " numbers");
            ++found;
        } else if (key == "bounds" || key == "baseframe") {
            skipBlock();
        } else {
            next();
        }
    }
    if (found != frames) fail("numFrames is " + std::to_string(frames) + ", but there are " + std::to_string(found));
}

}  // namespace

void checkMd5(std::string_view content, bool animation)
{
    if (content.find("MD5Version") == content.npos) throw Error("it does not begin as an MD5 file (\"MD5Version 10\")");
    Md5Check check(content);
    animation ? check.animation() : check.mesh();
}

}  // namespace mw
