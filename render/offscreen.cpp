// Surfaceless EGL, and PNG.
#include "render/offscreen.h"

#include <algorithm>
#include <cstring>
#include <epoxy/egl.h>
#include <filesystem>
#include <png.h>

#include "core/error.h"
#include "render/picture_target.h"

namespace mw {
namespace {

bool clientHas(const char* extension)
{
    const char* all = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    return all && std::strstr(all, extension) != nullptr;
}

/// Displays to try in turn: Mesa without a surface, a device, whatever is default.
std::vector<EGLDisplay> candidateDisplays()
{
    std::vector<EGLDisplay> out;
    const auto platformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platformDisplay && clientHas("EGL_MESA_platform_surfaceless"))
        out.push_back(platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    if (platformDisplay && queryDevices && clientHas("EGL_EXT_platform_device")) {
        EGLDeviceEXT devices[8];
        EGLint count = 0;
        if (queryDevices(8, devices, &count))
            for (EGLint i = 0; i < count; ++i) out.push_back(platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    }
    out.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return out;
}

struct Context {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    bool open(EGLDisplay candidate, bool debug)
    {
        if (candidate == EGL_NO_DISPLAY || !eglInitialize(candidate, nullptr, nullptr)) return false;
        display = candidate;
        const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        eglBindAPI(EGL_OPENGL_API);
        if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1) config = nullptr;
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                     4,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     1,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_CONTEXT_OPENGL_DEBUG,
                                     debug ? EGL_TRUE : EGL_FALSE,
                                     EGL_NONE};
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
        return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
    }
    void makeCurrent() const { eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context); }
    void close()
    {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        context = EGL_NO_CONTEXT;
        display = EGL_NO_DISPLAY;  // not terminated: another context of this process may use it
    }
    ~Context() { close(); }
};

void onMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text, const void* sink)
{
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION || type == GL_DEBUG_TYPE_PERFORMANCE || type == GL_DEBUG_TYPE_OTHER) return;
    auto* messages = static_cast<std::vector<std::string>*>(const_cast<void*>(sink));
    messages->emplace_back(text, length < 0 ? std::strlen(text) : size_t(length));
}

}  // namespace

struct Offscreen::Impl {
    std::vector<std::string> messages;
    Context context;
    std::unique_ptr<Renderer> renderer;
    PictureTarget target;

    ~Impl()
    {
        if (context.context != EGL_NO_CONTEXT) context.makeCurrent();
    }
};

Offscreen::Offscreen(bool debug) : impl_(std::make_unique<Impl>())
{
    bool open = false;
    for (const EGLDisplay display : candidateDisplays()) {
        open = impl_->context.open(display, debug);
        if (open) break;
        impl_->context.close();
    }
    if (!open) throw Error("no OpenGL 4.1 driver that draws without a display was found; install Mesa (packages libegl1 and libgl1-mesa-dri)");
    if (debug && epoxy_has_gl_extension("GL_KHR_debug")) {
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(onMessage, &impl_->messages);
    }
    impl_->renderer = std::make_unique<Renderer>();
}

Offscreen::~Offscreen() = default;

Renderer& Offscreen::renderer()
{
    impl_->context.makeCurrent();  // there may be several
    return *impl_->renderer;
}

const std::vector<std::string>& Offscreen::messages() const
{
    return impl_->messages;
}

Picture Offscreen::draw(const Frame& frame, int width, int height)
{
    impl_->context.makeCurrent();
    return impl_->target.draw(*impl_->renderer, frame, width, height);
}

void writePng(const Picture& picture, const std::string& file)
{
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = png_uint_32(picture.width);
    png.height = png_uint_32(picture.height);
    png.format = PNG_FORMAT_RGBA;
    const std::string part = file + ".part";
    if (!png_image_write_to_file(&png, part.c_str(), 0, picture.rgba.data(), 0, nullptr))
        throw Error(file, std::string("the picture could not be written (") + png.message + "); check the folder and the space left");
    std::error_code failed;
    std::filesystem::rename(part, file, failed);
    if (failed) {
        std::filesystem::remove(part, failed);
        throw Error(file, "the picture could not be put in its place; check the rights on the folder");
    }
}

}  // namespace mw
