#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace halbench::app {

/// How long the threads of this process have waited for a processor that others had, as the kernel counts
/// it; a kernel that does not count says none.
class ProcessorWait {
public:
    ProcessorWait() : m_before_ns(perThread_ns()) {}

    /// Of the thread that waited longest since this was made.
    double longest_s() const {
        double longest_ns = 0.0;
        for (const auto& [thread, now_ns] : perThread_ns()) {
            const auto before = m_before_ns.find(thread);
            longest_ns = std::max(longest_ns, now_ns - (before == m_before_ns.end() ? 0.0 : before->second));
        }
        return 1e-9 * longest_ns;
    }

private:
    static std::map<std::string, double> perThread_ns() {
        std::map<std::string, double> all;
        std::error_code error;
        for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", error)) {
            double ran_ns = 0.0;
            double waited_ns = 0.0;
            std::ifstream(thread.path() / "schedstat") >> ran_ns >> waited_ns;
            all[thread.path().filename().string()] = waited_ns;
        }
        return all;
    }

    std::map<std::string, double> m_before_ns;
};

} // namespace halbench::app
