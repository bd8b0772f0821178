#include "ui/panels/texture_slot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QSettings>
#include <QToolButton>
#include <QUrl>

#include "core/metrics/uv_layout.h"
#include "core/scene/edit.h"
#include "ui/look.h"
#include "ui/panels/decoded_picture.h"

namespace mw {
namespace {

struct Words {
    const char *title, *tip;
};
constexpr Words words[] = {{"Base colour", "Colour and alpha of the surface, sRGB."},
                           {"Metal and roughness", "Green is roughness, blue is metallic; linear."},
                           {"Normal", "Directions in the surface's own frame; linear, green up."},
                           {"Occlusion", "Red says how open a place is to light from around; linear."},
                           {"Emissive", "Light given off, sRGB."}};
constexpr int side = 40;

QString localPicture(const QMimeData* mime)
{
    for (const QUrl& u : mime->urls()) {
        const QString file = u.toLocalFile();
        for (const char* end : {".png", ".jpg", ".jpeg"})
            if (file.endsWith(end, Qt::CaseInsensitive)) return file;
    }
    return {};
}

}  // namespace

TextureSlot::TextureSlot(Session& session, TextureKind kind, QWidget* parent) : QWidget(parent), session_(session), kind_(kind)
{
    const Words& w = words[size_t(kind)];
    setAcceptDrops(true);
    setObjectName(QString("texture-%1").arg(QString::fromStdString(textureKinds()[size_t(kind)])));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(2, 2, 2, 2);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(1);
    grid->setColumnStretch(1, 1);
    auto* title = new QLabel(w.title, this);
    title->setToolTip(w.tip);
    title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    name_ = new QLabel(this);
    name_->setProperty("secondary", true);
    name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    error_ = new QLabel(this);
    error_->setProperty("bad", true);
    error_->setWordWrap(true);
    makeButtons();
    makeCoordinates();
    grid->addWidget(thumbnail_, 0, 0, 2, 1, Qt::AlignTop);
    grid->addWidget(title, 0, 1);
    grid->addWidget(name_, 1, 1);
    grid->addWidget(clear_, 0, 2, 2, 1, Qt::AlignVCenter);
    grid->addWidget(laid_, 2, 1, 1, 2);
    grid->addWidget(error_, 3, 0, 1, 3);
    error_->hide();
}

void TextureSlot::makeButtons()
{
    const Words& w = words[size_t(kind_)];
    thumbnail_ = new QToolButton(this);
    thumbnail_->setFixedSize(side + 4, side + 4);
    thumbnail_->setIconSize({side - 4, side - 4});
    thumbnail_->setProperty("tile", true);
    thumbnail_->setProperty("small", true);
    thumbnail_->setFocusPolicy(Qt::TabFocus);
    thumbnail_->setAccessibleName(QString("Choose picture: %1").arg(w.title));
    thumbnail_->setToolTip(QString("%1 Click to choose a PNG or JPEG, or drop one here.").arg(w.tip));
    connect(thumbnail_, &QToolButton::clicked, this, [this] { choose(); });
    clear_ = new QToolButton(this);
    clear_->setIcon(icon("x", look::tone().text2));
    clear_->setFixedSize(22, 22);
    clear_->setProperty("small", true);
    clear_->setFocusPolicy(Qt::TabFocus);
    clear_->setAccessibleName(QString("Clear picture: %1").arg(w.title));
    clear_->setToolTip("Take the picture off this material");
    connect(clear_, &QToolButton::clicked, this, [this] {
        run({"clear-texture", {{"node", nodeText(session_.document.scene(), node_)}, {"slot", slot_}, {"kind", textureKinds()[size_t(kind_)]}}});
    });
}

void TextureSlot::makeCoordinates()
{
    laid_ = new QWidget(this);
    auto* line = new QHBoxLayout(laid_);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(8);
    set_ = new QComboBox(laid_);
    set_->setFocusPolicy(Qt::TabFocus);
    set_->setMinimumWidth(56);
    set_->setAccessibleName("Texture coordinates");
    set_->setToolTip("Which texture coordinates of the mesh the picture uses");
    repeat_ = new QCheckBox("Repeat", laid_);
    repeat_->setFocusPolicy(Qt::TabFocus);
    repeat_->setToolTip("Outside 0 to 1 the picture goes on; off: its border does");
    line->addWidget(set_);
    line->addWidget(repeat_);
    line->addStretch(1);
    const auto changed = [this] {
        if (!filling_) run(callFor({}));
    };
    connect(set_, &QComboBox::activated, this, changed);
    connect(repeat_, &QCheckBox::clicked, this, changed);
}

void TextureSlot::show(NodeId node, int64_t slot)
{
    if (node != node_ || slot != slot_) error_->hide();
    node_ = node;
    slot_ = slot;
    refresh();
}

const Material::Texture* TextureSlot::texture() const
{
    const Scene& scene = session_.document.scene();
    const Node* n = scene.find(node_);
    const MeshObject* o = n ? scene.find(n->mesh) : nullptr;
    if (!o || slot_ >= int64_t(o->materials.size())) return nullptr;
    const Material* m = scene.find(o->materials[size_t(slot_)]);
    return m ? &textureOf(*m, kind_) : nullptr;
}

void TextureSlot::refresh()
{
    const Scene& scene = session_.document.scene();
    const Material::Texture* t = texture();
    const Image* image = t ? scene.find(t->image) : nullptr;
    filling_ = true;
    laid_->setVisible(image);
    clear_->setVisible(image);
    if (!image) {
        thumbnail_->setIcon(icon("plus", look::tone().text2));
        name_->setText("None");
        name_->setToolTip({});
    } else {
        const QImage small = decodedPicture(*image, 2 * side, this, [this] { refresh(); });
        thumbnail_->setIcon(small.isNull() ? icon("picture", look::tone().text2) : QIcon(QPixmap::fromImage(small)));
        const QSize size = pictureSize(*image);
        const QString file = image->name.empty() ? QString("Picture") : QString::fromStdString(image->name);
        const QString text = size.isEmpty() ? file : QString("%1 × %2, %3").arg(size.width()).arg(size.height()).arg(file);
        name_->setText(text);
        name_->setToolTip(text + (size.isEmpty() ? ". It cannot be decoded." : ""));
        const int64_t there = std::max<int64_t>(textureSets(scene.find(scene.node(node_).mesh)->base), t->set + 1);
        set_->clear();
        for (int64_t i = 0; i < there; ++i) set_->addItem(QString("Set %1").arg(i));
        set_->setCurrentIndex(t->set);
        repeat_->setChecked(t->repeat);
    }
    filling_ = false;
}

EditCall TextureSlot::callFor(const QString& file) const
{
    const Material::Texture* t = texture();
    const bool kept = t && t->image;
    return {"texture",
            {{"node", nodeText(session_.document.scene(), node_)},
             {"slot", slot_},
             {"kind", textureKinds()[size_t(kind_)]},
             {"set", kept ? int64_t(std::max(0, set_->currentIndex())) : int64_t(0)},
             {"repeat", kept ? repeat_->isChecked() : true},
             {"file", file.toStdString()}}};
}

void TextureSlot::run(const EditCall& call)
{
    if (!texture()) return;
    error_->hide();
    try {
        commitEdit(session_.document, call);
    } catch (const Error& e) {
        error_->setText(QString::fromStdString(e.what()));
        error_->show();
    }
    refresh();
}

void TextureSlot::take(const QString& file)
{
    if (!file.isEmpty()) run(callFor(file));
}

void TextureSlot::choose()
{
    QSettings settings;
    const QString file =
        QFileDialog::getOpenFileName(window(), "Choose a picture", settings.value("textures/folder").toString(), "Pictures (*.png *.jpg *.jpeg)");
    if (file.isEmpty()) return;
    settings.setValue("textures/folder", QFileInfo(file).path());
    take(file);
}

void TextureSlot::dragEnterEvent(QDragEnterEvent* e)
{
    if (localPicture(e->mimeData()).isEmpty()) return;
    e->acceptProposedAction();
    over_ = true;
    update();
}

void TextureSlot::dragLeaveEvent(QDragLeaveEvent*)
{
    over_ = false;
    update();
}

void TextureSlot::dropEvent(QDropEvent* e)
{
    over_ = false;
    update();
    e->acceptProposedAction();
    take(localPicture(e->mimeData()));
}

void TextureSlot::paintEvent(QPaintEvent*)
{
    if (!over_) return;
    QPainter p(this);
    p.setPen(QPen(look::tone().accentText, 2));
    p.drawRoundedRect(rect().adjusted(1, 1, -1, -1), 4, 4);
}

}  // namespace mw
