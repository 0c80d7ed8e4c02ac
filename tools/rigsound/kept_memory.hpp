// Memory of verbs that analyse.
#pragma once

namespace rigsound::tools {

/// Every stretch takes and frees the same megabytes dozens of times: kept, the system need not clear them
/// anew.
void keep_freed_memory();

}  // namespace rigsound::tools
