#include "ui/view_state.h"

namespace mw {

void ViewState::setViews(int count)
{
    count = std::max(1, count);
    if (count == views()) return;
    if (active_ >= count) activate(0);
    settings_.resize(size_t(count), *this);
    emit viewsChanged();
    touch();
}

void ViewState::activate(int view)
{
    if (view == active_ || view < 0 || view >= views()) return;
    settings_[size_t(active_)] = *this;
    static_cast<ViewSettings&>(*this) = settings_[size_t(view)];
    active_ = view;
    emit viewsChanged();
    emit changed();
}

void ViewState::follow(int view)
{
    if (!linked || views() == 1) return;
    const Camera moved = of(view).camera;
    for (int i = 0; i < views(); ++i) of(i).camera = moved;
    emit camerasFollowed();
}

void ViewState::take(ToolKind kind)
{
    tool = kind;
    emit toolChanged();
    emit brushChanged();
}

void ViewState::touch()
{
    for (int i = 0; i < views(); ++i) of(i).options.theme = options.theme;  // one for the window
    follow(active_);
    emit changed();
}

}  // namespace mw
