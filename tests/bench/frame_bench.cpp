// Frames of the viewport against a bare glDrawElements of the same triangles, with one matrix and one light, into the same framebuffer.
#include <benchmark/benchmark.h>

#include "render/gl.h"
#include "render/offscreen.h"

#include "bench/bench_meshes.h"

namespace mw {
namespace {

constexpr glm::ivec2 size{1280, 800};

constexpr const char* bareVertex = R"(#version 410 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 clipFromLocal;
uniform mat4 viewFromLocal;
out vec3 n;
void main()
{
    gl_Position = clipFromLocal * vec4(position, 1.0);
    n = mat3(viewFromLocal) * normal;
}
)";
constexpr const char* bareFragment = R"(#version 410 core
in vec3 n;
out vec4 color;
void main() { color = vec4(vec3(0.1 + 0.8 * max(dot(normalize(n), vec3(0.0, 0.6, 0.8)), 0.0)), 1.0); }
)";

GLuint bareProgram()
{
    const GLuint program = glCreateProgram();
    for (const auto& [stage, text] : {std::pair(GL_VERTEX_SHADER, bareVertex), std::pair(GL_FRAGMENT_SHADER, bareFragment)}) {
        const GLuint s = glCreateShader(GLenum(stage));
        glShaderSource(s, 1, &text, nullptr);
        glCompileShader(s);
        glAttachShader(program, s);
        glDeleteShader(s);
    }
    glLinkProgram(program);
    return program;
}

/// A framebuffer like the window's.
struct Window {
    gl::Framebuffer framebuffer;
    gl::Renderbuffer color, depth;

    explicit Window(int samples)
    {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
        glBindRenderbuffer(GL_RENDERBUFFER, color.id());
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, size.x, size.y);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color.get());
        glBindRenderbuffer(GL_RENDERBUFFER, depth.id());
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH24_STENCIL8, size.x, size.y);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth.get());
    }
};

/// The same arrays, drawn as plainly as can be.
class Bare {
public:
    Bare(const Mesh& mesh, const Frame& frame) : program_(bareProgram()), count_(GLsizei(mesh.triangulation().vertices.size()))
    {
        const auto fill = [](gl::Buffer& b, const auto& array) {
            glBindBuffer(GL_ARRAY_BUFFER, b.id());
            glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(array.bytes()), array.data(), GL_STATIC_DRAW);
        };
        glBindVertexArray(vertexArray_.id());
        fill(positions_, mesh.positions());
        fill(normals_, mesh.vertexNormals());
        fill(indices_, mesh.triangulation().vertices);
        gl::attribute({0, positions_.get()});
        gl::attribute({1, normals_.get()});
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
        Camera camera = frame.camera;
        camera.fitClip(boundsOf(frame));
        const glm::mat4 view(camera.viewFromWorld()), clip(camera.clipFromView(double(size.x) / size.y) * camera.viewFromWorld());
        glUseProgram(program_);
        glUniformMatrix4fv(glGetUniformLocation(program_, "clipFromLocal"), 1, GL_FALSE, &clip[0][0]);
        glUniformMatrix4fv(glGetUniformLocation(program_, "viewFromLocal"), 1, GL_FALSE, &view[0][0]);
    }
    ~Bare() { glDeleteProgram(program_); }
    void draw(GLuint target)
    {
        glBindFramebuffer(GL_FRAMEBUFFER, target);
        glViewport(0, 0, size.x, size.y);
        glDisable(GL_BLEND);
        glEnable(GL_DEPTH_TEST);
        glClearColor(0.2f, 0.2f, 0.2f, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUseProgram(program_);
        glBindVertexArray(vertexArray_.get());
        glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
        glFinish();
    }

private:
    GLuint program_;
    GLsizei count_;
    gl::VertexArray vertexArray_;
    gl::Buffer positions_, normals_, indices_;
};

Frame frameWith(const Mesh& mesh)
{
    Frame f;
    f.objects.push_back({});
    f.objects[0].node = NodeId{1};
    f.objects[0].mesh = mesh;
    frameTightly(f, double(size.x) / size.y);
    return f;
}

void frames(benchmark::State& state, const Mesh& mesh, int samples, const std::function<void(Frame&)>& change)
{
    if (mesh.faceCount() == 0) return state.SkipWithError("MESHWRIGHT_DATA is not set");
    Offscreen offscreen;
    Frame frame = frameWith(mesh);
    Window window(samples);
    Bare bare(mesh, frame);
    change(frame);
    const GLuint target = window.framebuffer.get();
    const auto ours = [&] {
        offscreen.renderer().draw(frame, target, size);
        glFinish();
    };
    ours();
    bare.draw(target);
    double bestOurs = 1e30, bestBare = 1e30;
    for (auto _ : state) {
        bestBare = std::min(bestBare, bench::quickest(2, [&] { bare.draw(target); }));
        bestOurs = std::min(bestOurs, bench::quickest(2, ours));
    }
    state.counters["bare_ms"] = 1e3 * bestBare;
    state.counters["frame_ms"] = 1e3 * bestOurs;
    state.counters["ratio"] = bestOurs / bestBare;
}

void plain(Frame&) {}
void selected(Frame& f)
{
    f.objects[0].selected = true;
}
void flat(Frame& f)
{
    f.options.shading = Shading::Flat;
}
void wired(Frame& f)
{
    f.options.wireOverlay = true;
}

BENCHMARK_CAPTURE(frames, scan_million_no_samples, bench::scanLike(), 0, plain)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, scan_million_4_samples, bench::scanLike(), 4, plain)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, scan_million_4_samples_selected, bench::scanLike(), 4, selected)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, scan_million_4_samples_flat, bench::scanLike(), 4, flat)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, scan_million_4_samples_wires, bench::scanLike(), 4, wired)->Iterations(2)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, dragon_871k_4_samples, bench::dragon(), 4, plain)->Iterations(3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace mw
