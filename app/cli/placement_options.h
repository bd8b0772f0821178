// Unit and up axis on the command line: of what is read (--unit, --up) and of what is written (--out-unit, --out-up).
#pragma once
#include "app/cli/arguments.h"
#include "core/io/io.h"

namespace mw::cli {

/// --unit and --up, which overrule what the file says. Throws UsageError.
ImportOptions takeImportOptions(Arguments& arguments);
/// --out-unit and --out-up; metres and y unless said. Throws UsageError.
Placement takeOutPlacement(Arguments& arguments);

}  // namespace mw::cli
