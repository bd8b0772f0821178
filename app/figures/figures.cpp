// All figures. A chapter's part joins with one line here, one in CMakeLists.txt.
#include "app/figures/figures.h"

#include <algorithm>
#include <string_view>

namespace mw::figures {

const std::vector<Figure>& allFigures()
{
    static const std::vector<Figure> all = [] {
        std::vector<Figure> out;
        const auto add = [&](std::vector<Figure> part) { out.insert(out.end(), part.begin(), part.end()); };
        add(chapter2Figures());
        add(chapter3CostFigures());
        add(chapter3DistanceFigures());
        add(chapter3SubdivisionFigures());
        add(chapter3MorphFigures());
        add(chapter3EmbeddingFigures());
        add(chapter2StructureFigures());
        add(chapter3CurveFigures());
        std::stable_sort(out.begin(), out.end(), [](const Figure& a, const Figure& b) { return std::string_view(a.id) < b.id; });
        return out;
    }();
    return all;
}

}  // namespace mw::figures
