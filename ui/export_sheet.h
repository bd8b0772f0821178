// File > Export: where to, in which format and how; what would be lost, said before it is written.
#pragma once
#include "core/io/io.h"
#include "ui/session.h"
#include "ui/sheet.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTreeWidget;

namespace mw {

class FileCommands;

class ExportSheet : public Sheet {
    Q_OBJECT

public:
    ExportSheet(Session& session, FileCommands& files, QWidget* over);

private:
    void makeForm();
    QLabel* label(const QString& text, int row);
    void makeFile(int row);
    void makeFormat(int row);
    void makeTicks(int row);
    void makeNumbers(int row);  ///< two rows: unit and up axis, triangles of terrains
    void makeList();
    void chooseFormat(const QString& ending);
    void browse();
    void refresh();
    void run();
    QString ending() const;
    WriteOptions options() const;
    void keep() const;
    Session& session_;
    FileCommands& files_;
    QGridLayout* form_;
    QLineEdit* file_;
    QComboBox *format_, *unit_, *up_;
    QCheckBox *binary_, *selected_;
    QSpinBox* triangles_;
    QLabel *summary_, *trouble_, *unitLabel_, *trianglesLabel_;
    QTreeWidget* list_;
    QPushButton* export_ = nullptr;
    std::shared_ptr<void> subscription_;
};

}  // namespace mw
