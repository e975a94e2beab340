// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Temporary_file.h"

#include "io/exclusive_file.h"
#include "io/output_format.h"

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <random>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <csignal>
#include <thread>

#include <unistd.h>
#endif

namespace segment_mesh {

namespace fs = std::filesystem;

namespace {

/// All files that are there now. A file comes, goes and gets its name under the mutex, so that a
/// signal finds each either listed or not there. Never destroyed: a signal may come late.
struct Registry
{
  std::mutex mutex;
  std::set<fs::path> paths;
};

Registry& registry()
{
  static Registry& instance = *new Registry;
  return instance;
}

constexpr std::string_view ending = ".part";
constexpr std::size_t number_of_digits = 16;

/// Of a target's name, of which a temporary file `.NAME.DIGITS.part` holds no more: a name has at most 255 bytes.
constexpr std::size_t longest_name = 255 - 2 - number_of_digits - ending.size();

std::string random_digits()
{
  std::random_device random;
  std::string digits;
  while (digits.size() < number_of_digits)
    digits += "0123456789abcdef"[random() % 16];
  return digits;
}

/// The name, cut off, of the target of the temporary file of this name; empty if that is the name of another file.
std::string target_of_temporary(const std::string& name)
{
  const std::size_t rest = 1 + number_of_digits + ending.size();
  if (name.size() <= 1 + rest || name.front() != '.' || name[name.size() - rest] != '.' ||
      name.compare(name.size() - ending.size(), ending.size(), ending) != 0 ||
      name.find_first_not_of("0123456789abcdef", name.size() - rest + 1) != name.size() - ending.size())
    return "";
  return name.substr(1, name.size() - rest - 1);
}

#if defined(__unix__) || defined(__APPLE__)

sigset_t signals_that_end()
{
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM, SIGUSR1, SIGUSR2}) {
    struct sigaction action;
    if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_DFL)
      sigaddset(&set, signal);
  }
  return set;
}

/// Waits for a signal; then nobody gets past the mutex any more.
void end_on_signal(sigset_t set)
{
  int signal = 0;
  if (sigwait(&set, &signal) != 0)
    return;
  registry().mutex.lock();
  for (const fs::path& path : registry().paths)
    unlink(path.c_str());
  std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  raise(signal);
}

#endif

} // namespace

Temporary_file::Temporary_file(fs::path target) : m_target(std::move(target))
{
  const std::string start = "." + m_target.filename().string().substr(0, longest_name) + ".";
  const std::lock_guard<std::mutex> lock(registry().mutex);
  while (m_file == nullptr) {
    m_path = m_target.parent_path() / (start + random_digits() + std::string(ending));
    m_file = open_exclusively(m_path, m_target);
  }
  registry().paths.insert(m_path);
}

Temporary_file::~Temporary_file()
{
  const std::lock_guard<std::mutex> lock(registry().mutex);
  if (registry().paths.erase(m_path) > 0) {
    std::error_code ignored;
    fs::remove(m_path, ignored);
  }
  std::fclose(m_file);
}

void Temporary_file::replace_target()
{
  copy_permissions(m_target, m_file);
  write_to_disk(m_file);
  {
    const std::lock_guard<std::mutex> lock(registry().mutex);
    fs::rename(m_path, m_target);
    registry().paths.erase(m_path);
  }
  write_folder_to_disk(m_target.parent_path());
}

void Temporary_file::remove_leftovers(const fs::path& folder, const std::set<std::string>& names)
{
  std::set<std::string> targets;
  std::vector<std::string> patterns;
  for (const std::string& name : names)
    if (name.find(segment_placeholder) == std::string::npos)
      targets.insert(name.substr(0, longest_name));
    else
      patterns.push_back(name);
  const auto is_target = [&](const std::string& name) {
    return targets.count(name) > 0 || std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
             return is_segment_file(pattern, name, longest_name);
           });
  };
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    if (is_target(target_of_temporary(entry->path().filename().string())))
      remove_if_left_behind(entry->path());
}

void Temporary_file::remove_all_on_signals()
{
#if defined(__unix__) || defined(__APPLE__)
  const sigset_t set = signals_that_end();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  try {
    std::thread(end_on_signal, set).detach();
  } catch (const std::system_error&) {
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  }
#endif
}

} // namespace segment_mesh
