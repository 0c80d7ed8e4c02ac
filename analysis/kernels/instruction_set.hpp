// Which of the compiled instruction sets this machine can run.
#pragma once

namespace rigsound::analysis {

enum class InstructionSet { kBaseline, kAvx2, kAvx512 };

/// Asked of the processor once. Thread: OFF, any.
InstructionSet instruction_set();

}  // namespace rigsound::analysis
