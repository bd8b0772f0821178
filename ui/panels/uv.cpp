#include "ui/panels/uv.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/metrics/uv_distortion.h"
#include "core/scene/edit.h"
#include "ui/elided.h"
#include "ui/evaluation_service.h"
#include "ui/look.h"
#include "ui/panels/decoded_picture.h"
#include "ui/panels/uv_canvas.h"
#include "ui/stack_edits.h"
#include "ui/theme.h"
#include "ui/variants.h"
#include "ui/viewport/frame_builder.h"
#include "ui/words.h"

namespace mw {
namespace {

constexpr int backdropSide = 2048, savedSide = 2048;

// What the colours of distortion mean: a bar with its ends, and the middle for area.
class UvLegend : public QWidget {
public:
    explicit UvLegend(QWidget* parent) : QWidget(parent)
    {
        setObjectName("uvLegend");
        setFixedHeight(34);
    }
    void set(UvColour colour, const UvRange& range)
    {
        colour_ = colour;
        range_ = range;
        setAccessibleName(colour == UvColour::Angle ? "Angle distortion" : "Area factor");
        setToolTip(colour == UvColour::Angle ? "Greater over lesser stretch of each face (s1 / s2): 1 keeps all angles"
                                             : "Area in the picture over area on the surface, 1 is the mesh's mean: blue is squeezed, red is spread");
        setVisible(colour != UvColour::None);
        update();
    }

private:
    void paintEvent(QPaintEvent*) override
    {
        QPainter p(this);
        const QRect bar(0, 2, width(), 10);
        for (int x = 0; x < bar.width(); ++x) {
            const double share = double(x) / std::max(1, bar.width() - 1);
            p.fillRect(bar.left() + x, bar.top(), 1, bar.height(), uvColourOf(colour_, uvValueAt(colour_, share, range_), range_));
        }
        p.setPen(tokens().text2);
        const QRect text(0, 14, width(), 20);
        const bool angle = colour_ == UvColour::Angle;
        p.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, "≤ " + (angle ? look::number(range_.low) : "1/" + look::number(range_.high)));
        if (!angle) p.drawText(text, Qt::AlignHCenter | Qt::AlignVCenter, "1");
        p.drawText(text, Qt::AlignRight | Qt::AlignVCenter, "≥ " + look::number(range_.high));
    }
    UvColour colour_ = UvColour::None;
    UvRange range_;
};

class UvPanel : public QWidget {
public:
    UvPanel(Session& session, QWidget* parent) : QWidget(parent), session_(session)
    {
        auto* outer = new QVBoxLayout(this);
        outer->setContentsMargins(8, 8, 8, 8);
        outer->setSpacing(6);
        empty_ = look::emptyState(this, &sentence_, &project_);
        project_->setText("Project from a box");
        project_->setToolTip("Give the mesh texture coordinates: each face from the side of the bounding box it looks to");
        connect(project_, &QPushButton::clicked, this, [this] { project(); });
        sentence_->setProperty("secondary", true);
        body_ = new QWidget(this);
        outer->addWidget(empty_);
        outer->addWidget(body_, 1);
        auto* box = new QVBoxLayout(body_);
        box->setContentsMargins(0, 0, 0, 0);
        box->setSpacing(6);
        makeBar(box);
        canvas_ = new UvCanvas(body_);
        box->addWidget(canvas_, 1);
        legend_ = new UvLegend(body_);
        legend_->hide();
        box->addWidget(legend_);
        makeFigures(box);
        connect(canvas_, &UvCanvas::picked, this, [this](ElementKind k, const std::vector<uint32_t>& i, Qt::KeyboardModifiers m) { pick(k, i, m); });
        connect(canvas_, &UvCanvas::pointed, this, [this](std::optional<glm::dvec2> t) {
            at_->setText(t ? QString("u %1  v %2").arg(t->x, 0, 'f', 3).arg(t->y, 0, 'f', 3).replace('-', QChar(0x2212)) : QString());
        });
        subscription_ = session_.document.subscribe([this](const Change& c) {
            if (c.aspects & (Aspect::Mesh | Aspect::Evaluation | Aspect::Stack | Aspect::Tree | Aspect::File | Aspect::Selection | Aspect::Material |
                             Aspect::History))
                refreshSoon();
        });
        connect(&session_.view, &ViewState::changed, this, [this] {
            canvas_->setPickKind(session_.view.pickKind);
            if (session_.view.shownLevel != levels_ || session_.view.variant != variants_ || session_.view.options.theme != canvas_->options().theme)
                refreshSoon();
        });
        if (session_.evaluations) connect(&session_.evaluations->variants(), &VariantService::changed, this, [this] { refreshSoon(); });
        refresh();
    }

private:
    void makeBar(QVBoxLayout* box)
    {
        auto* line = new QHBoxLayout;
        line->setSpacing(6);
        set_ = new QComboBox(body_);
        set_->setAccessibleName("Set of texture coordinates");
        set_->setToolTip("Which texture coordinates are shown");
        colour_ = new QComboBox(body_);
        colour_->setObjectName("uvColour");
        colour_->addItems({"Plain", "Angles", "Areas"});
        colour_->setAccessibleName("Colour by distortion");
        colour_->setToolTip("Plain, or coloured by how much angles or areas change");
        back_ = new QComboBox(body_);
        back_->addItems({"Texture", "Checker", "Empty"});
        back_->setAccessibleName("Behind the edges");
        back_->setToolTip("What lies behind: the base colour picture, a checker, nothing");
        for (QComboBox* c : {set_, colour_, back_}) {
            c->setFocusPolicy(Qt::TabFocus);
            c->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
            c->setMinimumContentsLength(3);
            c->setMinimumWidth(48);
            line->addWidget(c, 1);
        }
        box->addLayout(line);
        connect(set_, &QComboBox::activated, this, [this] { refresh(); });
        connect(colour_, &QComboBox::activated, this, [this] { show(); });
        connect(back_, &QComboBox::activated, this, [this] { show(); });
    }

    void makeFigures(QVBoxLayout* box)
    {
        auto* line = new QHBoxLayout;
        line->setSpacing(6);
        folded_ = new ElidedLabel(body_);
        folded_->setObjectName("uvFolded");
        folded_->setToolTip("Faces that lie upside down in the plane, hatched red; small ones are ringed");
        select_ = new QPushButton("Select", body_);
        select_->setObjectName("uvSelectFolded");
        select_->setAccessibleName("Select faces folded over");
        select_->setToolTip("Select the faces that are folded over");
        select_->setFocusPolicy(Qt::TabFocus);
        connect(select_, &QPushButton::clicked, this, [this] {
            if (subject_) choose({ElementKind::Face, subject_->layout.folded});
        });
        line->addWidget(folded_, 1);
        line->addWidget(select_);
        const auto button = [&](const char* image, const QString& name, const QString& tip, auto action) {
            auto* b = new QToolButton(body_);
            b->setIcon(icon(image, tokens().text2));
            b->setFixedSize(24, 24);
            b->setProperty("small", true);
            b->setFocusPolicy(Qt::TabFocus);
            b->setAccessibleName(name);
            b->setToolTip(tip);
            connect(b, &QToolButton::clicked, this, action);
            line->addWidget(b);
        };
        button("frame", "Fit", "Show all texture coordinates (F)", [this] { canvas_->fit(); });
        button("picture", "Save picture...", "Save the layout as PNG, 2,048 pixels wide", [this] { save(); });
        box->addLayout(line);
        auto* second = new QHBoxLayout;
        figures_ = new QLabel(body_);
        figures_->setObjectName("uvFigures");
        at_ = new QLabel(body_);
        for (QLabel* l : {figures_, at_}) {
            l->setProperty("secondary", true);
            l->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        }
        at_->setAlignment(Qt::AlignRight);
        at_->setToolTip("Coordinates under the pointer, v up");
        second->addWidget(figures_, 1);
        second->addWidget(at_, 1);
        box->addLayout(second);
    }

    void refreshSoon()
    {
        if (std::exchange(pending_, true)) return;
        QMetaObject::invokeMethod(
            this, [this] { refresh(); }, Qt::QueuedConnection);
    }

    void project()
    {
        try {
            commitEdit(session_.document, {"project-uv", {{"node", nodeText(session_.document.scene(), session_.document.selection().active())}}});
        } catch (const Error& e) {
            say(QString::fromStdString(e.what()));
        }
    }

    void say(const QString& text, bool canProject = false)
    {
        project_->setVisible(canProject);
        sentence_->setText(text);
        empty_->setVisible(!text.isEmpty());
        body_->setVisible(text.isEmpty());
    }

    void refresh()
    {
        pending_ = false;
        levels_ = session_.view.shownLevel;
        variants_ = session_.view.variant;
        const MeshId id = edits::activeMesh(session_.document);
        if (!session_.document.scene().find(id)) {
            subject_ = nullptr;
            canvas_->setSubject(nullptr);
            return say("Select a mesh to see its texture coordinates.");
        }
        node_ = session_.document.selection().active();
        isVariant_ = showsVariant(session_.view, id);
        const Mesh mesh = shownMesh(session_, session_.view, id);
        const int64_t sets = textureSets(mesh);
        if (sets == 0) {
            subject_ = nullptr;
            canvas_->setSubject(nullptr);
            return say("This mesh has no texture coordinates.", mesh.faceCount() > 0);
        }
        say({});
        if (set_->count() != int(sets)) {
            const int kept = std::clamp(set_->currentIndex(), 0, int(sets) - 1);
            set_->clear();
            for (int i = 0; i < sets; ++i) set_->addItem(QString("Set %1").arg(i));
            set_->setCurrentIndex(kept);
        }
        set_->setVisible(sets > 1);  // one set leaves nothing to choose
        measure(mesh, set_->currentIndex());
        show();
    }

    /// Layout and distortion of another mesh, off this thread; the old ones stay until then.
    void measure(const Mesh& mesh, int64_t set)
    {
        const Attribute* a = textureSet(mesh, set);
        if (a->id() == coordinates_ && mesh.positions().id() == positions_ && mesh.cornerVertex().id() == corners_ && (subject_ || job_)) return;
        coordinates_ = a->id();
        positions_ = mesh.positions().id();
        corners_ = mesh.cornerVertex().id();
        if (job_) session_.jobs.cancel(job_);
        subject_ = nullptr;
        canvas_->setSubject(nullptr);
        figures_->setText("Measuring");
        const quint64 turn = ++turn_;
        job_ = session_.jobs.start(
            "Texture coordinates",
            [this, mesh, set, turn, alive = std::weak_ptr<int>(alive_)](Progress& progress) -> std::function<void()> {
                auto subject = std::make_shared<UvSubject>();
                subject->mesh = mesh;
                subject->layout = uvLayoutOf(mesh, set);
                progress.at(0.5f);
                subject->distortion = std::get<Table>(apply(operation("uv-distortion"), mesh, {{"set", set}}, &progress));
                return [this, subject, turn, alive] {
                    if (!alive.lock() || turn != turn_) return;
                    job_ = 0;
                    subject_ = subject;
                    canvas_->setSubject(subject);
                    show();
                };
            },
            [this, turn, alive = std::weak_ptr<int>(alive_)](const QString& text) {
                if (alive.lock() && turn == turn_) say(text);
            });
    }

    void show()
    {
        UvOptions o;
        o.colour = UvColour(colour_->currentIndex());
        o.theme = session_.view.options.theme;
        o.picture = back_->currentIndex() != 2;
        if (back_->currentIndex() == 0) o.backdrop = backdrop();
        const Selection& s = session_.document.selection();
        if (s.elementsOf == node_ && !isVariant_) o.selection = s.elements;
        canvas_->setPickKind(session_.view.pickKind);
        canvas_->setOptions(std::move(o));
        if (!subject_) return;
        const size_t n = subject_->layout.folded.size();
        folded_->setText(n ? counted(n, "face", "faces") + " folded over" : QString("No face folded over"));
        folded_->setProperty("bad", n > 0);
        folded_->style()->unpolish(folded_);
        folded_->style()->polish(folded_);
        select_->setVisible(n > 0 && !isVariant_);
        const UvColour colour = UvColour(colour_->currentIndex());
        legend_->set(colour, uvRangeOf(*subject_, colour));
        const auto& sum = subject_->distortion.summary;
        const QString text = colour == UvColour::Angle  ? QString("mean %1, most %2").arg(look::number(sum[0].second), look::number(sum[1].second))
                             : colour == UvColour::Area ? QString("%1 to %2").arg(look::number(sum[2].second), look::number(sum[3].second))
                                                        : counted(subject_->layout.seams, "seam edge", "seam edges");
        figures_->setText(text);
        figures_->setToolTip(QString("%1; angles: mean %2, most %3; areas: %4 to %5 of the mean")
                                 .arg(counted(subject_->layout.seams, "seam edge", "seam edges"), look::number(sum[0].second),
                                      look::number(sum[1].second), look::number(sum[2].second), look::number(sum[3].second)));
    }

    /// The base colour picture of the first slot that has one.
    QImage backdrop()
    {
        const Scene& scene = session_.document.scene();
        const MeshObject* o = scene.find(scene.node(node_).mesh);
        for (const MaterialId id : o ? o->materials : std::vector<MaterialId>{}) {
            const Material* m = scene.find(id);
            const Image* image = m ? scene.find(m->baseColorTexture.image) : nullptr;
            if (image) return decodedPicture(*image, backdropSide, this, [this] { refreshSoon(); });
        }
        return {};
    }

    void choose(ElementSet set)
    {
        Selection s = session_.document.selection();
        s.elementsOf = set.indices.empty() ? NodeId{} : node_;
        s.elements = std::move(set);
        if (!s.elements.indices.empty() && session_.view.pickKind == PickKind::Object) {
            session_.view.pickKind = PickKind::Face;  // what is selected is to be seen in the 3D view, too
            session_.view.touch();
        }
        session_.document.select(std::move(s));
    }

    void pick(ElementKind kind, const std::vector<uint32_t>& indices, Qt::KeyboardModifiers modifiers)
    {
        if (isVariant_) return;
        const Selection& s = session_.document.selection();
        const bool joins = (modifiers & (Qt::ShiftModifier | Qt::ControlModifier)) && s.elementsOf == node_ && s.elements.kind == kind;
        if (!joins) return choose({kind, indices});
        if (kind == ElementKind::Edge) return choose(withEdge(s.elements, indices, modifiers & Qt::ControlModifier));
        std::vector<uint32_t> next;
        if (modifiers & Qt::ControlModifier)
            std::set_symmetric_difference(s.elements.indices.begin(), s.elements.indices.end(), indices.begin(), indices.end(),
                                          std::back_inserter(next));
        else
            std::set_union(s.elements.indices.begin(), s.elements.indices.end(), indices.begin(), indices.end(), std::back_inserter(next));
        choose({kind, std::move(next)});
    }

    static ElementSet withEdge(ElementSet set, const std::vector<uint32_t>& edge, bool toggle)
    {
        if (edge.size() != 2) return set;
        for (size_t i = 0; i + 1 < set.indices.size(); i += 2) {
            if (set.indices[i] != edge[0] || set.indices[i + 1] != edge[1]) continue;
            if (toggle) set.indices.erase(set.indices.begin() + ptrdiff_t(i), set.indices.begin() + ptrdiff_t(i) + 2);
            return set;
        }
        set.indices.insert(set.indices.end(), edge.begin(), edge.end());
        return set;
    }

    void save()
    {
        if (!subject_) return;
        QString file = QFileDialog::getSaveFileName(window(), "Save picture", "texture-coordinates.png", "PNG (*.png)");
        if (file.isEmpty()) return;
        if (QFileInfo(file).suffix().isEmpty()) file += ".png";
        const glm::dvec2 half = 0.5 * (subject_->layout.high - subject_->layout.low), middle = subject_->layout.low + half;
        const double reach = std::max({0.5, half.x + std::abs(middle.x - 0.5), half.y + std::abs(middle.y - 0.5)});
        UvView view;
        view.perUnit = savedSide / (2.04 * reach);
        session_.jobs.start("Save picture", [subject = subject_, view, options = canvas_->options(), file](Progress&) -> std::function<void()> {
            if (!uvPicture(*subject, view, options, {savedSide, savedSide}).save(file))
                throw Error(file.toStdString() + ": cannot be written; choose another folder");
            return [] {};
        });
    }

    Session& session_;
    QWidget *empty_, *body_;
    QLabel *sentence_, *folded_, *figures_, *at_;
    QComboBox *set_, *colour_, *back_;
    QPushButton *select_, *project_;
    UvCanvas* canvas_;
    UvLegend* legend_;
    NodeId node_;
    std::shared_ptr<const UvSubject> subject_;
    const void *coordinates_ = nullptr, *positions_ = nullptr, *corners_ = nullptr;
    std::map<MeshId, size_t> levels_;
    std::map<MeshId, Modifier> variants_;
    bool isVariant_ = false;  // elements are picked where the result is shown
    quint64 job_ = 0, turn_ = 0;
    std::shared_ptr<int> alive_ = std::make_shared<int>(0);
    bool pending_ = false;
    std::shared_ptr<void> subscription_;
};

}  // namespace

QWidget* makeUvPanel(Session& session, QWidget* parent)
{
    return new UvPanel(session, parent);
}

}  // namespace mw
