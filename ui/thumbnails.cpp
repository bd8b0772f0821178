#include <epoxy/gl.h>
// epoxy comes before Qt's own OpenGL headers
#include <QCryptographicHash>
#include <QDir>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QStandardPaths>

#include "core/scene/samples.h"
#include "ui/evaluation_service.h"
#include "ui/thumbnails.h"

namespace mw {
namespace {

QString pathOf(const QString& key)
{
    const QByteArray name = QCryptographicHash::hash(key.toUtf8(), QCryptographicHash::Sha1).toHex();
    return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + "/meshwright/thumbnails/" + name + ".png";
}

// The samples belong to the version: another one may make them otherwise.
QString sampleKey(const char* id)
{
    return QString("sample:%1").arg(id);
}

}  // namespace

QPixmap thumbnails::kept(const QString& key)
{
    QPixmap p(pathOf(key));
    if (!p.isNull()) p.setDevicePixelRatio(double(p.width()) / width);
    return p;
}

void thumbnails::keep(const QString& key, const QImage& picture)
{
    if (picture.isNull()) return;
    // The middle of it, in our shape.
    const double scale = std::min(double(picture.width()) / width, double(picture.height()) / height);
    const QSize part(int(width * scale), int(height * scale));
    const QRect middle(QPoint((picture.width() - part.width()) / 2, (picture.height() - part.height()) / 2), part);
    const QString file = pathOf(key);
    QDir().mkpath(QFileInfo(file).path());
    picture.copy(middle).scaled(2 * width, 2 * height, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).save(file);
}

struct ThumbnailMaker::Drawing {
    QOffscreenSurface surface;
    QOpenGLContext context;
    std::unique_ptr<Renderer> renderer;

    ~Drawing()
    {
        if (context.isValid()) context.makeCurrent(&surface);
        renderer.reset();
        context.doneCurrent();
    }
};

ThumbnailMaker::ThumbnailMaker(Session& session, QObject* parent) : QObject(parent), session_(session) {}

ThumbnailMaker::~ThumbnailMaker() = default;

void ThumbnailMaker::makeSamples()
{
    for (const Sample& s : samples()) {
        const QString key = sampleKey(s.id);
        if (!thumbnails::kept(key).isNull()) continue;
        session_.jobs.start(QString("Picture of %1").arg(s.title), [this, key, &s](Progress& progress) -> std::function<void()> {
            Scene scene = s.make();
            Evaluator evaluator;
            for (const MeshId id : scene.meshes()) {
                MeshObject shown = *scene.find(id);
                shown.base = evaluator.evaluate(shown, &progress, {}, &scene).result();
                shown.stack.clear();
                warm(shown.base);
                scene.set(id, std::move(shown));
            }
            return [this, key, scene = std::move(scene)] { draw(key, scene); };
        });
    }
}

void ThumbnailMaker::draw(const QString& key, const Scene& scene)
{
    if (!drawing_) {
        drawing_ = std::make_unique<Drawing>();
        drawing_->surface.create();
        drawing_->context.setShareContext(QOpenGLContext::globalShareContext());
        if (!drawing_->context.create()) return;
    }
    if (!drawing_->context.isValid() || !drawing_->context.makeCurrent(&drawing_->surface)) return;
    try {
        if (!drawing_->renderer) drawing_->renderer = std::make_unique<Renderer>();
        Frame frame = frameOf(scene, [&](MeshId id) { return scene.find(id)->base; });
        if (!frame.objects.empty()) frame.bones.clear();
        frame.options.grid = frame.options.axes = frame.options.orientationMarker = frame.options.legend = false;
        frameTightly(frame, double(thumbnails::width) / thumbnails::height);
        QOpenGLFramebufferObjectFormat format;
        format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
        format.setSamples(4);
        QOpenGLFramebufferObject target(2 * thumbnails::width, 2 * thumbnails::height, format);
        drawing_->renderer->draw(frame, target.handle(), {2 * thumbnails::width, 2 * thumbnails::height});
        thumbnails::keep(key, target.toImage().convertToFormat(QImage::Format_RGB32));
        emit made(key);
    } catch (const std::exception&) {
        // Without a picture the sample is shown by its name alone.
    }
    drawing_->context.doneCurrent();
}

}  // namespace mw
