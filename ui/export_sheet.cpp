#include "ui/export_sheet.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTreeWidget>

#include "core/io/preflight.h"
#include "ui/file_commands.h"
#include "ui/placement_words.h"
#include "ui/theme.h"
#include "ui/words.h"

namespace mw {
namespace {

bool hasBinary(const QString& ending)
{
    return ending == ".ply" || ending == ".stl" || ending == ".off";
}

bool hasUnits(const QString& ending)
{
    return ending != ".glb" && ending != ".gltf" && ending != ".png";
}

}  // namespace

ExportSheet::ExportSheet(Session& session, FileCommands& files, QWidget* over) : Sheet("Export", over, {600, 520}), session_(session), files_(files)
{
    setObjectName("exportSheet");
    makeForm();
    makeList();
    auto* line = new QHBoxLayout;
    trouble_ = new QLabel(this);
    trouble_->setProperty("bad", true);
    trouble_->setWordWrap(true);
    export_ = new QPushButton(icon("export", Qt::white), "Export", this);
    export_->setObjectName("exportRun");
    export_->setProperty("primary", true);
    export_->setFocusPolicy(Qt::TabFocus);
    export_->setToolTip("Write the file; a file of that name is replaced when the new one is whole");
    connect(export_, &QPushButton::clicked, this, &ExportSheet::run);
    connect(file_, &QLineEdit::returnPressed, this, &ExportSheet::run);
    line->addWidget(trouble_, 1);
    line->addWidget(export_);
    body()->addLayout(line);
    const QString kept = QSettings().value("export/ending", ".glb").toString();
    const QString folder = QSettings().value("export/folder", QDir::homePath()).toString();
    file_->setText(QDir::toNativeSeparators(folder + "/" + QFileInfo(files_.title()).completeBaseName() + kept));
    chooseFormat(kept);
    subscription_ = session_.document.subscribe([this](const Change& c) {
        if (c.aspects & (Aspect::Tree | Aspect::Mesh | Aspect::Stack | Aspect::Evaluation | Aspect::Selection | Aspect::File | Aspect::History))
            refresh();
    });
    refresh();
}

void ExportSheet::makeForm()
{
    form_ = new QGridLayout;
    form_->setSpacing(8);
    form_->setColumnStretch(1, 1);
    makeFile(0);
    makeFormat(1);
    makeTicks(2);
    makeNumbers(3);
    body()->addLayout(form_);
}

QLabel* ExportSheet::label(const QString& text, int row)
{
    auto* l = new QLabel(text, this);
    l->setMinimumWidth(90);
    form_->addWidget(l, row, 0);
    return l;
}

void ExportSheet::makeFile(int row)
{
    label("File", row);
    file_ = new QLineEdit(this);
    file_->setObjectName("exportFile");
    file_->setAccessibleName("File");
    file_->setToolTip("Where it is written; the ending says the format");
    auto* other = new QPushButton("Browse...", this);
    other->setToolTip("Choose folder and name");
    other->setFocusPolicy(Qt::TabFocus);
    connect(other, &QPushButton::clicked, this, &ExportSheet::browse);
    connect(file_, &QLineEdit::textChanged, this, [this] {
        const int i = format_->findData(ending());
        if (i >= 0) format_->setCurrentIndex(i);
        refresh();
    });
    form_->addWidget(file_, row, 1);
    form_->addWidget(other, row, 2);
}

void ExportSheet::makeFormat(int row)
{
    label("Format", row);
    format_ = new QComboBox(this);
    format_->setObjectName("exportFormat");
    format_->setAccessibleName("Format");
    format_->setToolTip("What the list below says depends on it");
    format_->setFocusPolicy(Qt::TabFocus);
    for (const FileFormat& f : fileFormats())
        if (f.writes)
            for (const std::string& e : f.extensions)
                format_->addItem(QString("%1 (%2)").arg(QString::fromStdString(f.name), QString::fromStdString(e)), QString::fromStdString(e));
    connect(format_, &QComboBox::activated, this, [this](int i) { chooseFormat(format_->itemData(i).toString()); });
    form_->addWidget(format_, row, 1, 1, 2);
}

void ExportSheet::makeTicks(int row)
{
    binary_ = new QCheckBox("Binary", this);
    binary_->setToolTip("Smaller and faster to read; untick for a text that can be read by eye");
    binary_->setChecked(QSettings().value("export/binary", true).toBool());
    selected_ = new QCheckBox("Only what is selected", this);
    selected_->setObjectName("exportSelected");
    selected_->setToolTip("The selected nodes and what is below them");
    auto* boxes = new QHBoxLayout;
    for (QCheckBox* b : {binary_, selected_}) {
        b->setFocusPolicy(Qt::TabFocus);
        boxes->addWidget(b);
        connect(b, &QCheckBox::toggled, this, [this] { refresh(); });
    }
    boxes->addStretch(1);
    form_->addLayout(boxes, row, 1, 1, 2);
}

void ExportSheet::makeNumbers(int row)
{
    const QSettings settings;
    unitLabel_ = label("Numbers in", row);
    unit_ = unitCombo(settings.value("export/unit", 1.0).toDouble(), this);
    up_ = upCombo(UpAxis(std::clamp(settings.value("export/up", 0).toInt(), 0, 2)), this);
    auto* place = new QHBoxLayout;
    place->addWidget(unit_);
    place->addWidget(up_);
    place->addStretch(1);
    form_->addLayout(place, row, 1, 1, 2);
    trianglesLabel_ = label("Terrains", row + 1);
    triangles_ = new QSpinBox(this);
    triangles_->setAccessibleName("Triangles of each terrain");
    triangles_->setToolTip("Most triangles of the mesh that stands for a terrain. 2 to 20,000,000");
    triangles_->setRange(2, 20'000'000);
    triangles_->setGroupSeparatorShown(true);
    triangles_->setSuffix(" triangles");
    triangles_->setValue(settings.value("export/triangles", 200'000).toInt());
    connect(triangles_, &QSpinBox::valueChanged, this, [this] { refresh(); });
    form_->addWidget(triangles_, row + 1, 1, Qt::AlignLeft);
}

void ExportSheet::makeList()
{
    summary_ = new QLabel(this);
    summary_->setObjectName("exportSummary");
    list_ = new QTreeWidget(this);
    list_->setObjectName("exportList");
    list_->setAccessibleName("What will not be in the file");
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setWordWrap(true);
    list_->setColumnCount(2);
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list_->header()->setStretchLastSection(true);
    list_->setToolTip("Enter or a double click selects the node and frames it");
    connect(list_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
        const std::string name = item->text(0).toStdString();
        for (const NodeId n : session_.document.scene().nodes())
            if (!name.empty() && session_.document.scene().node(n).name == name) {
                session_.document.select({{n}, {}, {}});
                return session_.view.frameNodes({n});
            }
    });
    body()->addWidget(summary_);
    body()->addWidget(list_, 1);
}

QString ExportSheet::ending() const
{
    return "." + QFileInfo(file_->text()).suffix().toLower();
}

void ExportSheet::chooseFormat(const QString& e)
{
    const QFileInfo now(file_->text());
    const bool known = format_->findData("." + now.suffix().toLower()) >= 0;
    const QString base = known ? file_->text().left(file_->text().size() - now.suffix().size() - 1) : file_->text();
    file_->setText(base + e);
}

void ExportSheet::browse()
{
    const QString file =
        QFileDialog::getSaveFileName(this, "Export", file_->text(), FileCommands::writeFilter(), nullptr, QFileDialog::DontConfirmOverwrite);
    if (!file.isEmpty()) file_->setText(QFileInfo(file).suffix().isEmpty() ? file + ending() : file);
}

WriteOptions ExportSheet::options() const
{
    WriteOptions o;
    o.binary = binary_->isChecked();
    if (hasUnits(ending())) o.placement = {unitOf(unit_), upOf(up_)};
    o.terrainTriangles = size_t(triangles_->value());
    return o;
}

// What the validator of the format would say, and what has no place in it.
void ExportSheet::refresh()
{
    if (!export_) return;
    const QString e = ending();
    const Document& d = session_.document;
    binary_->setVisible(hasBinary(e));
    for (QWidget* w : {static_cast<QWidget*>(unit_), static_cast<QWidget*>(up_), static_cast<QWidget*>(unitLabel_)}) w->setVisible(hasUnits(e));
    const bool ground = !d.scene().terrains().empty() && e != ".png";
    triangles_->setVisible(ground);
    trianglesLabel_->setVisible(ground);
    selected_->setEnabled(!d.selection().nodes.empty());
    const auto shown = [&d](MeshId id) { return d.shownMesh(id); };
    const Scene scene = selected_->isChecked() ? onlyNodes(d.scene(), d.selection().nodes) : d.scene();
    const auto items = preflight(scene, e.toStdString(), options(), shown);
    list_->clear();
    size_t errors = 0, warnings = 0;
    for (const PreflightItem& i : items) {
        const bool error = i.severity == PreflightItem::Severity::Error, warning = i.severity == PreflightItem::Severity::Warning;
        errors += error;
        warnings += warning;
        auto* row = new QTreeWidgetItem({QString::fromStdString(i.node), QString::fromStdString(i.text)});
        row->setIcon(0, error ? icon("error", tokens().error) : warning ? icon("warning", tokens().warning) : icon("ok", tokens().success));
        row->setData(0, Qt::AccessibleTextRole, QString(error ? "Error" : warning ? "Warning" : "Note") + ", " + QString::fromStdString(i.node));
        row->setToolTip(1, QString::fromStdString(i.text));
        list_->addTopLevelItem(row);
    }
    const ExportedAmount amount = amountOf(scene, shown);
    QString text = counted(amount.meshes, "mesh", "meshes") + ", " + counted(amount.faces, "face", "faces");
    if (amount.clips) text += ", " + counted(amount.clips, "clip", "clips");
    text += errors          ? ". It cannot be written yet:"
            : warnings      ? ". " + counted(warnings, "thing has", "things have") + " no place in this format:"
            : items.empty() ? ". Everything has a place in this format."
                            : ". Nothing is lost:";
    summary_->setText(text);
    const QFileInfo info(file_->text());
    const QString whyNot = errors                              ? QString()
                           : info.completeBaseName().isEmpty() ? "Give the file a name."
                           : !QFileInfo(info.path()).isDir()   ? "There is no folder " + info.path() + ". Choose another one."
                           : info.exists()                     ? "A file of this name is there; it is replaced."
                                                               : QString();
    trouble_->setText(whyNot);
    export_->setEnabled(errors == 0 && (whyNot.isEmpty() || info.exists()));
}

void ExportSheet::keep() const
{
    QSettings settings;
    settings.setValue("export/ending", ending());
    settings.setValue("export/folder", QFileInfo(file_->text()).absolutePath());
    settings.setValue("export/binary", binary_->isChecked());
    settings.setValue("export/unit", unitOf(unit_));
    settings.setValue("export/up", int(upOf(up_)));
    settings.setValue("export/triangles", triangles_->value());
}

void ExportSheet::run()
{
    if (!export_->isEnabled()) return;
    keep();
    files_.exportTo(file_->text(), options(), selected_->isChecked());
    deleteLater();
}

}  // namespace mw
