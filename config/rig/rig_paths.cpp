#include "rigsound/config/rig_paths.hpp"

#include <string>

#include "rigsound/machine/input_error.hpp"
#include "rigsound/socket/unix_listener.hpp"

namespace rigsound::config {
namespace {

void check_socket(const Rig& rig) {
  const std::string& socket = rig.control.socket;
  const std::string problem = socket.empty() ? "" : socket_path_problem(socket);
  if (!problem.empty())
    throw InputError(rig.file.string(), rig.control.socket_line, "control.socket",
                     "\"" + socket + "\" " + problem);
}

}  // namespace

void check_paths(const Rig& rig) {
  check_socket(rig);
  control_token(rig);
}

}  // namespace rigsound::config
