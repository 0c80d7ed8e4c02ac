// Built several times with RIGSOUND_ISA naming the instruction set. The build gives Eigen another namespace
// for each, or the linker would merge the copies of its functions across instruction sets.
#include "kernels/kl_kernels.hpp"

#include <Eigen/Core>

#include "kernels/isa_names.hpp"

namespace rigsound::analysis {
namespace {

using Matrix = Eigen::MatrixXf;
using Map = Eigen::Map<Matrix>;
using ConstMap = Eigen::Map<const Matrix>;

constexpr int kTile = 128;  // frames; the tile (1025 x 128 floats) stays in the second-level cache
constexpr float kFloor = 1e-9f;

void update_activations(const Factorisation& f) {
  const ConstMap V(f.V, f.bins, f.frames), W(f.W, f.bins, f.words);
  Map H(f.H, f.words, f.frames);
  const Eigen::ArrayXf sums = W.colwise().sum().transpose();
  Matrix tile(f.bins, kTile), numerator(f.words, kTile);
  for (int n = 0; n < f.frames; n += kTile) {
    const int width = std::min(kTile, f.frames - n);
    auto quotient = tile.leftCols(width);
    auto h = H.middleCols(n, width);
    quotient.noalias() = W * h;
    quotient.array() = V.middleCols(n, width).array() / quotient.array();
    numerator.leftCols(width).noalias() = W.transpose() * quotient;
    h.array() *= numerator.leftCols(width).array().colwise() / sums;
    h = h.cwiseMax(kFloor);
  }
}

void update_words(const Factorisation& f) {
  const ConstMap V(f.V, f.bins, f.frames), H(f.H, f.words, f.frames);
  Map W(f.W, f.bins, f.words);
  Matrix tile(f.bins, kTile), numerator = Matrix::Zero(f.bins, f.words);
  for (int n = 0; n < f.frames; n += kTile) {
    const int width = std::min(kTile, f.frames - n);
    auto quotient = tile.leftCols(width);
    const auto h = H.middleCols(n, width);
    quotient.noalias() = W * h;
    quotient.array() = V.middleCols(n, width).array() / quotient.array();
    numerator.noalias() += quotient * h.transpose();
  }
  W.array() *= numerator.array().rowwise() / H.rowwise().sum().transpose().array();
  W = W.cwiseMax(kFloor);
}

void multiply(const float* A, const float* B, float* C, int n) {
  Map(C, n, n).noalias() = ConstMap(A, n, n) * ConstMap(B, n, n);
}

}  // namespace

extern const KlKernels RIGSOUND_OF_ISA(kKlKernels_);
const KlKernels RIGSOUND_OF_ISA(kKlKernels_) = {RIGSOUND_ISA_NAME, update_activations, update_words,
                                                multiply};

}  // namespace rigsound::analysis
