#include "ui/panels/generators.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "ui/elided.h"
#include "ui/look.h"
#include "ui/parameter_form.h"
#include "ui/terrain_edits.h"
#include "ui/theme.h"

namespace mw {
namespace {

class GeneratorsPanel : public QWidget {
public:
    GeneratorsPanel(Session& session, QWidget* parent) : QWidget(parent), session_(session), sources_(edits::heightSources())
    {
        auto* outer = new QVBoxLayout(this);
        outer->setContentsMargins(8, 8, 0, 0);
        outer->setSpacing(6);
        auto* line = new QHBoxLayout;
        line->setContentsMargins(0, 0, 8, 0);
        choice_ = new ElidedComboBox(this);
        choice_->setObjectName("generator");
        choice_->setAccessibleName("Generator");
        choice_->setToolTip("What makes the height map");
        choice_->setFocusPolicy(Qt::TabFocus);
        for (const Operation* op : sources_) choice_->addItem(QString::fromStdString(op->title));
        go_ = new QPushButton(icon("terrain", Qt::white), "Generate", this);
        go_->setObjectName("generate");
        go_->setProperty("primary", true);
        go_->setFocusPolicy(Qt::TabFocus);
        line->addWidget(choice_, 1);
        line->addWidget(go_);
        outer->addLayout(line);
        summary_ = new QLabel(this);
        summary_->setProperty("secondary", true);
        summary_->setWordWrap(true);
        outer->addWidget(summary_);
        area_ = new QScrollArea(this);
        area_->setWidgetResizable(true);
        outer->addWidget(area_, 1);
        connect(choice_, &QComboBox::currentIndexChanged, this, [this] { showForm({}); });
        connect(go_, &QPushButton::clicked, this, [this] { generate(); });
        subscription_ = session_.document.subscribe([this](const Change& c) {
            if (c.aspects & (Aspect::Terrain | Aspect::History | Aspect::Selection | Aspect::File)) refresh();
        });
        showForm({});
        refresh();
    }

private:
    void generate()
    {
        const int i = choice_->currentIndex();
        if (i < 0 || !form_) return;
        const Operation& op = *sources_[size_t(i)];
        const ParameterValues values = checked(op.parameters, form_->values());
        const NodeId node = edits::activeTerrain(session_.document);
        if (node)
            edits::generate(session_, node, op, values);
        else
            edits::newTerrain(session_, op, values);
    }

    void showForm(const ParameterValues& values)
    {
        const int i = choice_->currentIndex();
        if (i < 0) return;
        const Operation& op = *sources_[size_t(i)];
        summary_->setText(QString::fromStdString(op.summary));
        auto* inside = new QWidget(area_);
        auto* box = new QVBoxLayout(inside);
        box->setContentsMargins(0, 4, 8, 8);
        form_ = new ParameterForm(op.parameters, checked(op.parameters, values), inside);
        form_->setObjectName("generatorForm");
        box->addWidget(form_);
        box->addStretch(1);
        area_->setWidget(inside);
        inside->show();
        look::keepWide(area_);
    }

    /// The source that made the active terrain is shown with what it was made with.
    void refresh()
    {
        const NodeId node = edits::activeTerrain(session_.document);
        const TerrainObject* object = edits::terrainOf(session_.document, node);
        go_->setText(object ? "Generate" : "New terrain");
        go_->setToolTip(object ? "Make the map anew; undo brings the old one back" : "Add a terrain to the scene");
        if (!object || object->sourceOperation.empty() || (node == shown_ && object->sourceValues == values_ && object->sourceOperation == source_))
            return;
        shown_ = node;
        values_ = object->sourceValues;
        source_ = object->sourceOperation;
        for (size_t i = 0; i < sources_.size(); ++i) {
            if (sources_[i]->id != source_) continue;
            choice_->setCurrentIndex(int(i));
            showForm(values_);
        }
    }

    Session& session_;
    std::shared_ptr<void> subscription_;
    std::vector<const Operation*> sources_;
    QComboBox* choice_ = nullptr;
    QPushButton* go_ = nullptr;
    QLabel* summary_ = nullptr;
    QScrollArea* area_ = nullptr;
    ParameterForm* form_ = nullptr;
    NodeId shown_;
    ParameterValues values_;
    std::string source_;
};

}  // namespace

QWidget* makeGeneratorsPanel(Session& session, QWidget* parent)
{
    return new GeneratorsPanel(session, parent);
}

}  // namespace mw
