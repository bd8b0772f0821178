// Terrains and brushes.
#include <QFileDialog>
#include <algorithm>

#include "ui/actions.h"
#include "ui/file_commands.h"
#include "ui/terrain_edits.h"

namespace mw {

void Actions::makeTerrain()
{
    Session& s = s_;
    const auto said = [this](const QString& text) {
        if (!text.isEmpty()) emit files_.trouble(text);
    };
    const QString pictures = "Height maps (*.png *.tga *.pgm)";
    terrainActions << make("New terrain", "terrain", "", "Add a terrain by diamond-square", [&s] { edits::newTerrain(s); });
    terrainActions << make("New terrain from picture...", "picture", "", "Add a terrain whose heights are a grey picture",
                           [this, &s, said, pictures] {
                               const QString file = QFileDialog::getOpenFileName(window_, "New terrain from picture", {}, pictures);
                               if (!file.isEmpty()) edits::importPicture(s, file, true, said);
                           });
    terrainEdits << make("Import height map...", "open", "", "A picture in place of the active terrain's map", [this, &s, said, pictures] {
        const QString file = QFileDialog::getOpenFileName(window_, "Import a height map", {}, pictures);
        if (!file.isEmpty()) edits::importPicture(s, file, false, said);
    });
    terrainEdits << make("Export height map...", "export", "", "The active terrain's map as a grey PNG of 16 bits", [this, &s, said] {
        QString file = QFileDialog::getSaveFileName(window_, "Export the height map", "heights.png", "PNG, 16 bits (*.png)");
        if (file.isEmpty()) return;
        if (!file.endsWith(".png", Qt::CaseInsensitive)) file += ".png";
        edits::exportPicture(s, edits::activeTerrain(s.document), file, said);
    });
    terrainEdits << make("Terrain to mesh", "mesh", "", "A mesh that follows the active terrain, beside it",
                         [&s] { edits::terrainToMesh(s, edits::activeTerrain(s.document), 100'000); });
    const auto brush = [this, &s](const char* text, const char* iconName, const char* tip, Brush::Kind kind) {
        terrainEdits << make(text, iconName, "", tip, [&s, kind] {
            s.view.brush.kind = kind;
            s.view.take(ToolKind::Brush);
        });
    };
    brush("Raise the ground", "raise", "Take the brush that lifts", Brush::Kind::Raise);
    brush("Lower the ground", "lower", "Take the brush that digs", Brush::Kind::Lower);
    const auto key = [this, &s](const char* text, const char* keys, const char* tip, double factor, double add) {
        terrainEdits << make(
            text, "", keys, tip,
            [&s, factor, add] {
                s.view.brush.radius = std::clamp(s.view.brush.radius * factor, 0.1, 10000.0);
                s.view.brush.strength = std::clamp(s.view.brush.strength + add, 0.01, 1.0);
                s.view.touchBrush();
            },
            true);
    };
    key("Smaller brush", "[", "Radius down by a tenth", 1 / 1.1, 0);
    key("Larger brush", "]", "Radius up by a tenth", 1.1, 0);
    key("Weaker brush", "Shift+[; {", "Strength down by 0.05", 1, -0.05);
    key("Stronger brush", "Shift+]; }", "Strength up by 0.05", 1, 0.05);
}

}  // namespace mw
