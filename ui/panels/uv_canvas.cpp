#include "ui/panels/uv_canvas.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ui/theme.h"

namespace mw {
namespace {

constexpr double margin = 0.25;  // of the picture beyond each side, so that a short pan shows no gap
constexpr double leastPerUnit = 4, mostPerUnit = 2e6;

double toSegment(QPointF p, QPointF a, QPointF b)
{
    const QPointF d = b - a;
    const double length = QPointF::dotProduct(d, d);
    const double t = length > 0 ? std::clamp(QPointF::dotProduct(p - a, d) / length, 0.0, 1.0) : 0;
    const QPointF gap = p - a - t * d;
    return std::hypot(gap.x(), gap.y());
}

}  // namespace

UvCanvas::UvCanvas(QWidget* parent) : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    setObjectName("uvCanvas");
    setAccessibleName("Texture coordinates");
    setAccessibleDescription("Arrow keys pan, plus and minus zoom, Home fits");
    setToolTip("Click selects, Shift adds, Ctrl toggles. Drag pans, the wheel zooms to the pointer, F fits.");
    pool_.setMaxThreadCount(1);
    again_.setSingleShot(true);
    connect(&again_, &QTimer::timeout, this, [this] { render(); });
}

UvCanvas::~UvCanvas()
{
    if (stop_) *stop_ = true;
    pool_.waitForDone();
}

void UvCanvas::setSubject(std::shared_ptr<const UvSubject> subject)
{
    subject_ = std::move(subject);
    picture_ = {};
    fitted_ = false;
    if (subject_) fit();
}

void UvCanvas::setOptions(UvOptions options)
{
    options_ = std::move(options);
    renderSoon(0);
}

glm::dvec2 UvCanvas::coordinatesAt(QPointF p) const
{
    return view_.centre + glm::dvec2(p.x() - width() / 2.0, height() / 2.0 - p.y()) / view_.perUnit;
}

QPointF UvCanvas::placeOf(glm::dvec2 t) const
{
    return {width() / 2.0 + (t.x - view_.centre.x) * view_.perUnit, height() / 2.0 - (t.y - view_.centre.y) * view_.perUnit};
}

void UvCanvas::fit()
{
    if (!subject_) return;
    const glm::dvec2 low = glm::min(subject_->layout.low, glm::dvec2(0)), high = glm::max(subject_->layout.high, glm::dvec2(1));
    const glm::dvec2 size = high - low;
    view_.centre = 0.5 * (low + high);
    view_.perUnit = std::clamp(0.94 * std::min(width() / size.x, height() / size.y), 1e-6, mostPerUnit);
    fitted_ = true;
    viewChanged();
}

void UvCanvas::viewChanged()
{
    update();
    renderSoon(picture_.isNull() ? 0 : 60);
}

void UvCanvas::renderSoon(int milliseconds)
{
    if (!again_.isActive() || milliseconds == 0) again_.start(milliseconds);
}

void UvCanvas::render()
{
    if (!subject_ || width() < 2 || height() < 2) return;
    if (running_) {  // the one on its way is of no use any more
        *stop_ = true;
        return;
    }
    running_ = true;
    stop_ = std::make_shared<std::atomic<bool>>(false);
    UvOptions options = options_;
    options.pixelRatio = devicePixelRatioF();
    const QSize size(int(width() * (1 + 2 * margin)), int(height() * (1 + 2 * margin)));
    pool_.start([this, subject = subject_, view = view_, options, size, stop = stop_] {
        QImage made = uvPicture(*subject, view, options, size, stop.get());
        QMetaObject::invokeMethod(
            this,
            [this, made = std::move(made), subject, view, size, stop] {
                running_ = false;
                // It may have been done before it heard that something newer is wanted.
                if (made.isNull() || *stop || subject != subject_) return render();
                picture_ = made;
                pictured_ = view;
                picturedSize_ = size;
                update();
            },
            Qt::QueuedConnection);
    });
}

void UvCanvas::paintEvent(QPaintEvent*)
{
    QPainter p(this);
    p.fillRect(rect(), currentTheme() == Theme::Dark ? QColor("#1F2226") : QColor("#EDEFF2"));
    if (!subject_ || picture_.isNull()) return;
    // Where the picture lies now: moved and scaled with the view until the new one is there.
    const double scale = view_.perUnit / pictured_.perUnit;
    const QPointF middle = placeOf(pictured_.centre);
    const QSizeF size = QSizeF(picturedSize_) * scale;
    p.setRenderHint(QPainter::SmoothPixmapTransform, scale != 1);
    if (scale == 1)
        p.drawImage(QPointF(std::round(middle.x() - size.width() / 2), std::round(middle.y() - size.height() / 2)), picture_);
    else
        p.drawImage(QRectF(QPointF(middle.x() - size.width() / 2, middle.y() - size.height() / 2), size), picture_);
    if (!hasFocus()) return;
    p.setPen(QPen(tokens().accentText, 2));
    p.drawRect(rect().adjusted(1, 1, -1, -1));
}

void UvCanvas::resizeEvent(QResizeEvent* e)
{
    QWidget::resizeEvent(e);
    if (fitted_)
        fit();
    else
        viewChanged();
}

void UvCanvas::zoom(double factor, QPointF at)
{
    const glm::dvec2 under = coordinatesAt(at);
    view_.perUnit = std::clamp(view_.perUnit * factor, std::min(leastPerUnit, view_.perUnit), mostPerUnit);
    view_.centre += under - coordinatesAt(at);
    fitted_ = false;
    viewChanged();
}

void UvCanvas::wheelEvent(QWheelEvent* e)
{
    zoom(std::pow(1.0015, e->angleDelta().y()), e->position());
    e->accept();
}

void UvCanvas::mousePressEvent(QMouseEvent* e)
{
    press_ = last_ = e->position();
    moved_ = false;
}

void UvCanvas::mouseMoveEvent(QMouseEvent* e)
{
    emit pointed(coordinatesAt(e->position()));
    if (!e->buttons()) return;
    moved_ = moved_ || (e->position() - press_).manhattanLength() > 3;
    if (!moved_) return;
    const QPointF d = e->position() - last_;
    last_ = e->position();
    view_.centre -= glm::dvec2(d.x(), -d.y()) / view_.perUnit;
    fitted_ = false;
    viewChanged();
}

void UvCanvas::mouseReleaseEvent(QMouseEvent* e)
{
    if (!moved_ && e->button() == Qt::LeftButton) pick(e->position(), e->modifiers());
}

void UvCanvas::leaveEvent(QEvent*)
{
    emit pointed(std::nullopt);
}

void UvCanvas::keyPressEvent(QKeyEvent* e)
{
    const double step = 40 / view_.perUnit;
    const QPointF middle(width() / 2.0, height() / 2.0);
    switch (e->key()) {
        case Qt::Key_Home:
        case Qt::Key_F:
            return fit();
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            return zoom(1.25, middle);
        case Qt::Key_Minus:
            return zoom(0.8, middle);
        case Qt::Key_Left:
            view_.centre.x -= step;
            break;
        case Qt::Key_Right:
            view_.centre.x += step;
            break;
        case Qt::Key_Up:
            view_.centre.y += step;
            break;
        case Qt::Key_Down:
            view_.centre.y -= step;
            break;
        default:
            return QWidget::keyPressEvent(e);
    }
    fitted_ = false;
    viewChanged();
}

void UvCanvas::pick(QPointF at, Qt::KeyboardModifiers modifiers)
{
    if (!subject_) return;
    const UvLayout& l = subject_->layout;
    const auto& corners = subject_->mesh.cornerVertex();
    if (pickKind_ == PickKind::Vertex || pickKind_ == PickKind::Edge) {
        const bool edges = pickKind_ == PickKind::Edge;
        double best = edges ? 7 : 10;  // as in the 3D view
        std::vector<uint32_t> found;
        for (size_t e = 0; e < l.kinds.size(); ++e) {
            const uint32_t a = l.edges[2 * e], b = l.edges[2 * e + 1];
            const QPointF pa = placeOf(l.corners[a]), pb = placeOf(l.corners[b]);
            if (edges) {
                const double d = toSegment(at, pa, pb);
                if (d < best) best = d, found = {std::min(corners[a], corners[b]), std::max(corners[a], corners[b])};
                continue;
            }
            for (const auto& [c, p] : {std::pair(a, pa), std::pair(b, pb)}) {
                const double d = std::hypot(p.x() - at.x(), p.y() - at.y());
                if (d < best) best = d, found = {corners[c]};
            }
        }
        emit picked(edges ? ElementKind::Edge : ElementKind::Vertex, std::move(found), modifiers);
        return;
    }
    const std::vector<uint32_t> faces = facesAt(subject_->mesh, l, coordinatesAt(at));
    // Again at the same place: the next of those that lie on each other.
    const bool again = (at - lastClick_).manhattanLength() <= 3;
    lastChoice_ = again && !faces.empty() ? (lastChoice_ + 1) % faces.size() : 0;
    lastClick_ = at;
    std::vector<uint32_t> one;
    if (!faces.empty()) one = {faces[lastChoice_]};
    emit picked(ElementKind::Face, std::move(one), modifiers);
}

}  // namespace mw
