// Units and up axis of files, in words; and the small form that changes them after a file was read.
#pragma once
#include <QString>
#include <QWidget>

#include "core/io/io.h"
#include "ui/session.h"

class QComboBox;

namespace mw {

QString placementText(const Placement& p);  ///< "metres, Y up"
QComboBox* unitCombo(double metresPerUnit, QWidget* parent);
double unitOf(const QComboBox* combo);
QComboBox* upCombo(UpAxis up, QWidget* parent);
UpAxis upOf(const QComboBox* combo);

/// "Change...": a card near the banner. What is chosen is an edit, and kept for files of this kind when that is ticked.
QWidget* askForPlacement(Session& session, const QString& file, const Placement& now, const std::vector<NodeId>& roots, QWidget* below);

}  // namespace mw
