// Counts heap allocations of this program, so that a test can forbid them.
#pragma once

namespace rigsound::tests {

/// Calls of operator new, malloc and their kin on this thread so far.
long allocations();

}  // namespace rigsound::tests
