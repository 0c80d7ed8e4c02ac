// Memory of verbs that analyse.
#pragma once

namespace rigsound::tools {

/// Every stretch takes and frees the same megabytes dozens of times: kept, the system need not clear them
/// anew, and where it has pages of 2 MiB it clears them in few steps. Call once, before the first stretch.
void keep_freed_memory();

}  // namespace rigsound::tools
