// What gallery draws for the operations of the catalog, beside the book's figures.
#pragma once
#include <span>

#include "render/renderer.h"

namespace mw::cli {

struct OperationPicture {
    const char* id;         ///< file name
    const char* operation;  ///< of the catalog
    Frame (*make)();
};
std::span<const OperationPicture> operationPictures();

}  // namespace mw::cli
