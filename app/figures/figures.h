// The list of figures: each chapter's file gives its own. How to add one is told in figure.h.
#pragma once
#include "app/figures/figure.h"

namespace mw::figures {

// One file each, one line each in figures.cpp.
std::vector<Figure> chapter2Figures();             ///< chapter2.cpp
std::vector<Figure> chapter2StructureFigures();    ///< chapter2_structures.cpp
std::vector<Figure> chapter3CostFigures();         ///< chapter3_costs.cpp: 3.01 to 3.09
std::vector<Figure> chapter3CurveFigures();        ///< chapter3_curves.cpp: 3.10 to 3.12
std::vector<Figure> chapter3SubdivisionFigures();  ///< chapter3_subdivision.cpp: 3.13 to 3.24
std::vector<Figure> chapter3EmbeddingFigures();    ///< chapter3_embedding.cpp: 3.25 to 3.28
std::vector<Figure> chapter3DistanceFigures();     ///< chapter3_distance.cpp: 3.29
std::vector<Figure> chapter3MorphFigures();        ///< chapter3_morph.cpp: 3.30 to 3.36

/// All of them, in the order of the book.
const std::vector<Figure>& allFigures();

}  // namespace mw::figures
