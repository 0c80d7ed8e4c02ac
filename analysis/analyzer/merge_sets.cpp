#include "rigsound/analysis/merge_sets.hpp"

#include <algorithm>
#include <set>

#include "analyzer/set_laws.hpp"
#include "rigsound/config/bank_files.hpp"
#include "rigsound/config/sound_set_index.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/atomic_folder.hpp"
#include "rigsound/file/large_block.hpp"
#include "rigsound/file/make_folders.hpp"
#include "rigsound/file/read_files.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

bool same_bytes(const fs::path& a, const fs::path& b) {
  const LargeBlock x = read_block(a), y = read_block(b);
  return std::equal(x.data(), x.data() + x.size(), y.data(), y.data() + y.size());
}

/// Relative names of the files in a folder, or "" for a file itself.
std::set<fs::path> files_in(const fs::path& at) {
  if (!fs::is_directory(at)) return {fs::path()};
  std::set<fs::path> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(at))
    if (entry.is_regular_file()) names.insert(entry.path().lexically_relative(at));
  return names;
}

bool same_content(const fs::path& a, const fs::path& b) {
  const std::set<fs::path> names = files_in(a);
  return names == files_in(b) && std::all_of(names.begin(), names.end(), [&](const fs::path& name) {
           return name.empty() ? same_bytes(a, b) : same_bytes(a / name, b / name);
         });
}

bool same(const config::BankEntry& a, const config::BankEntry& b) {
  return a.rods == b.rods && a.rock == b.rock && a.feed_bar == b.feed_bar &&
         a.percussion_bar == b.percussion_bar && a.gain_db == b.gain_db;
}

bool same(const config::LawsEntry& a, const config::LawsEntry& b) { return difference(a.laws, b.laws) == 0; }
bool same(const config::RockEntry& a, const config::RockEntry& b) { return a.stiffness == b.stiffness; }
bool same(const config::ToolEntry& a, const config::ToolEntry& b) { return a.kind == b.kind; }

bool named_alike(const config::BankEntry& a, const config::BankEntry& b) {
  return a.name == b.name && a.situation == b.situation;
}
bool named_alike(const config::LawsEntry& a, const config::LawsEntry& b) {
  return a.laws.rods == b.laws.rods && a.rock == b.rock;
}
template <class Named>
bool named_alike(const Named& a, const Named& b) {
  return a.name == b.name;
}

/// Entries of one kind in both indices must agree.
template <class Entry>
void require_agreement(const char* kind, const std::vector<Entry>& there, const std::vector<Entry>& added,
                       const fs::path& file) {
  for (const Entry& entry : added)
    for (const Entry& other : there)
      if (named_alike(entry, other) && !same(entry, other)) {
        std::string which = "any";
        if constexpr (std::is_same_v<Entry, config::LawsEntry>)
          which = std::to_string(entry.laws.rods) + " rods " + entry.rock;
        else
          which = entry.name;
        throw InputError(file.string(), 0, kind,
                         which +
                             " is described in another way than in the sets before, expected the same or "
                             "another name");
      }
}

/// Copies a part of a set, unless the very same is there.
class Join {
 public:
  /// `into`: where it is built; `out`: what it will be, for messages.
  Join(fs::path into, fs::path out) : into_(std::move(into)), out_(std::move(out)) {}

  void add(const fs::path& set, const Progress& progress) {
    const config::SoundSetIndex index = config::load_index(set), there = index_so_far();
    const fs::path file = set / "soundset.toml";
    require_agreement("rock", there.rocks, index.rocks, file);
    require_agreement("laws", there.laws, index.laws, file);
    require_agreement("bank", there.banks, index.banks, file);
    require_agreement("tool", there.tools, index.tools, file);
    for (std::size_t i = 0; i < index.banks.size(); ++i) {
      const std::string& name = index.banks[i].name;
      config::load_bank(set / "banks" / name);  // a damaged one is told and not passed on
      take(set, fs::path("banks") / name);
      show(progress, i + 1, index.banks.size());
    }
    for (const config::ToolEntry& tool : index.tools) take(set, fs::path("tools") / (tool.name + ".json"));
    for (const std::string& name : index.backgrounds) take(set, fs::path("backgrounds") / name);
    config::merge_index(into_, index);
    came_from_.push_back(set);
  }

  config::SoundSetIndex index_so_far() const {
    std::error_code none;
    return fs::exists(into_ / "soundset.toml", none) ? config::load_index(into_) : config::SoundSetIndex{};
  }

 private:
  void take(const fs::path& set, const fs::path& name) {
    std::error_code error;
    const fs::path from = set / name, to = into_ / name;
    if (!fs::exists(from, error))
      throw InputError((set / "soundset.toml").string(), "names " + name.string() + ", which is not there");
    if (fs::exists(to, error)) {
      if (same_content(from, to)) return;
      throw InputError(from.string(), "differs from " + (owner_of(name) / name).string() +
                                          ", expected the same or another name");
    }
    make_folders(to.parent_path());
    fs::copy(from, to, fs::copy_options::recursive, error);
    if (error) throw DeviceError(out_.string() + ": cannot be written: " + error.message());
  }

  /// The set that had it first.
  fs::path owner_of(const fs::path& name) const {
    std::error_code error;
    for (const fs::path& set : came_from_)
      if (fs::exists(set / name, error)) return set;
    return out_;
  }

  fs::path into_, out_;
  std::vector<fs::path> came_from_;
};

}  // namespace

MergedSets merge_sets(const std::vector<fs::path>& sets, const fs::path& out, const Progress& progress) {
  constexpr double kCopied = 0.3;  // of the work; most is waiting for the disk
  require_apart({out}, sets);
  for (const fs::path& set : sets) require_outside(out, {set});
  AtomicFolder folder(out);
  std::error_code error;
  if (fs::exists(out, error)) {
    config::load_index(out);
    // Whatever is written here is renamed into place, so that no file of the old folder changes.
    fs::copy(out, folder.temporary(), fs::copy_options::recursive | fs::copy_options::create_hard_links,
             error);
    if (error) throw DeviceError(out.string() + ": cannot be copied: " + error.message());
  }
  Join join(folder.temporary(), out);
  const double each = kCopied / static_cast<double>(sets.size());
  for (std::size_t i = 0; i < sets.size(); ++i)
    join.add(sets[i], part_of(progress, each * static_cast<double>(i), each * static_cast<double>(i + 1)));
  MergedSets merged;
  add_laws(folder.temporary(), (out / "soundset.toml").string(), merged.notes);
  const config::SoundSetIndex index = join.index_so_far();
  std::set<std::string> banks;
  for (const config::BankEntry& bank : index.banks) banks.insert(bank.name);
  merged.banks = static_cast<int>(banks.size());
  merged.tools = static_cast<int>(index.tools.size());
  merged.backgrounds = static_cast<int>(index.backgrounds.size());
  folder.commit(part_of(progress, kCopied, 1));
  return merged;
}

}  // namespace rigsound::analysis
