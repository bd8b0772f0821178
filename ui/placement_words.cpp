#include "ui/placement_words.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "core/scene/edit.h"
#include "ui/file_commands.h"

namespace mw {
namespace {

struct Unit {
    const char* name;
    double metres;
};
constexpr Unit units[] = {{"metres", 1}, {"centimetres", 0.01}, {"millimetres", 0.001}, {"inches", 0.0254}, {"feet", 0.3048}, {"kilometres", 1000}};

std::string upText(UpAxis up)
{
    return up == UpAxis::Y ? "y" : up == UpAxis::Z ? "z" : "x";
}

}  // namespace

QString placementText(const Placement& p)
{
    QString unit = QString("units of %1 m").arg(p.metresPerUnit, 0, 'g', 6);
    for (const Unit& u : units)
        if (std::abs(p.metresPerUnit / u.metres - 1) < 1e-6) unit = u.name;
    return unit + ", " + QString::fromStdString(upText(p.up)).toUpper() + " up";
}

QComboBox* unitCombo(double metresPerUnit, QWidget* parent)
{
    auto* combo = new QComboBox(parent);
    combo->setAccessibleName("Unit");
    combo->setToolTip("What one unit of the file is");
    combo->setFocusPolicy(Qt::TabFocus);
    for (const Unit& u : units) combo->addItem(QString(u.name).replace(0, 1, QString(u.name[0]).toUpper()), u.metres);
    for (int i = 0; i < combo->count(); ++i)
        if (std::abs(combo->itemData(i).toDouble() / metresPerUnit - 1) < 1e-6) combo->setCurrentIndex(i);
    return combo;
}

double unitOf(const QComboBox* combo)
{
    return combo->currentData().toDouble();
}

QComboBox* upCombo(UpAxis up, QWidget* parent)
{
    auto* combo = new QComboBox(parent);
    combo->setAccessibleName("Up axis");
    combo->setToolTip("The axis of the file that points up");
    combo->setFocusPolicy(Qt::TabFocus);
    combo->addItems({"Y up", "Z up", "X up"});
    combo->setCurrentIndex(int(up));
    return combo;
}

UpAxis upOf(const QComboBox* combo)
{
    return UpAxis(combo->currentIndex());
}

QWidget* askForPlacement(Session& session, const QString& file, const Placement& now, const std::vector<NodeId>& roots, QWidget* below)
{
    auto* card = new QFrame(below->window(), Qt::Popup);
    card->setObjectName("popup");
    card->setAttribute(Qt::WA_DeleteOnClose);
    auto* grid = new QGridLayout(card);
    grid->setContentsMargins(12, 10, 12, 12);
    grid->setSpacing(8);
    auto* unit = unitCombo(now.metresPerUnit, card);
    unit->setObjectName("placementUnit");
    auto* up = upCombo(now.up, card);
    up->setObjectName("placementUp");
    const QString ending = QFileInfo(file).suffix().toUpper();
    auto* keep = new QCheckBox("Read all " + ending + " files so", card);
    keep->setObjectName("placementKeep");
    keep->setToolTip("Also the next ones; what they were read as is said each time");
    keep->setFocusPolicy(Qt::TabFocus);
    auto* apply = new QPushButton("Apply", card);
    apply->setObjectName("placementApply");
    apply->setProperty("primary", true);
    apply->setFocusPolicy(Qt::TabFocus);
    apply->setToolTip("Turn and scale what was read; undo takes it back");
    grid->addWidget(new QLabel("Unit", card), 0, 0);
    grid->addWidget(unit, 0, 1);
    grid->addWidget(new QLabel("Up", card), 1, 0);
    grid->addWidget(up, 1, 1);
    grid->addWidget(keep, 2, 0, 1, 2);
    grid->addWidget(apply, 3, 1, Qt::AlignRight);
    QObject::connect(apply, &QPushButton::clicked, card, [=, &session] {
        const Placement to{unitOf(unit), upOf(up)};
        if (keep->isChecked()) FileCommands::keepPlacement(file, to);
        std::vector<NodeId> there;
        for (const NodeId n : roots)
            if (session.document.scene().find(n)) there.push_back(n);
        if (!there.empty() && !(to == now))
            commitEdit(session.document, {"place-import",
                                          {{"nodes", nodeText(session.document.scene(), there)},
                                           {"from-unit", now.metresPerUnit},
                                           {"from-up", upText(now.up)},
                                           {"unit", to.metresPerUnit},
                                           {"up", upText(to.up)}}});
        session.view.frameNodes({});
        card->close();
    });
    card->adjustSize();
    card->move(below->mapToGlobal(QPoint(std::max(0, below->width() - card->width() - 40), below->height() + 2)));
    card->show();
    unit->setFocus();
    return card;
}

}  // namespace mw
