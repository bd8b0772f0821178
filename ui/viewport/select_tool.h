// The tool that only picks and looks: what the view does by itself.
#pragma once
#include "ui/viewport/tool.h"

namespace mw {

class SelectTool : public Tool {
public:
    using Tool::Tool;
    QString hint(Qt::KeyboardModifiers m) const override
    {
        if (m & Qt::ShiftModifier && m & Qt::ControlModifier) return "Drag round what is to be added \u00b7 let go with Ctrl alone to remove";
        if (m & Qt::ShiftModifier) return "Shift+click adds \u00b7 Shift+drag boxes, adding \u00b7 Shift+middle-drag pans";
        if (m & Qt::ControlModifier) return "Ctrl+click toggles \u00b7 Ctrl+Shift+drag draws a lasso";
        return "Click picks \u00b7 Drag orbits \u00b7 Shift+drag boxes \u00b7 Right-drag pans \u00b7 F frames";
    }
};

}  // namespace mw
