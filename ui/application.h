// What a process must do before and after it makes its QApplication to have our window in it.
#pragma once

class QApplication;

namespace mw {

void prepareApplication();                 ///< before: shared contexts, OpenGL 4.1 core, exact scaling
void dressApplication(QApplication& app);  ///< after: names for the settings, theme
}  // namespace mw
