#include "drill/drill_input.hpp"

namespace rigsound::drill {

int BankChoices::add(const ClickBank& bank, double share) noexcept {
  if (share <= 0) return -1;
  for (int i = 0; i < count; ++i)
    if (choice[i].bank == &bank) {
      choice[i].share += share;
      return i;
    }
  if (count == kMaxChoices) return -1;
  choice[count] = {&bank, share};
  return count++;
}

const ClickBank& BankChoices::drawn(double uniform) const noexcept {
  int i = 0;
  for (; i + 1 < count && uniform >= choice[i].share; ++i) uniform -= choice[i].share;
  return *choice[i].bank;
}

}  // namespace rigsound::drill
