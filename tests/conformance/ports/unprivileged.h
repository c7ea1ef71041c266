#pragma once

#include "tests/conformance/ports/mock_usb.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

namespace halbench::devices {

/// While it lives, these nodes are forbidden to this program, which is an ordinary user's even if it is
/// root's.
class Unprivileged {
public:
    Unprivileged(const MockMachine& machine, const std::vector<std::string>& nodes) {
        if (m_wasRoot) { // the machine is a folder of root's own
            allow(machine.pathOf(""));
            for (const auto& entry : std::filesystem::recursive_directory_iterator(machine.pathOf(""))) {
                if (!entry.is_symlink()) {
                    allow(entry.path());
                }
            }
        }
        for (const std::string& node : nodes) {
            EXPECT_EQ(::chmod(machine.pathOf(node).c_str(), 0), 0);
        }
        if (m_wasRoot) {
            EXPECT_EQ(::setresgid(Nobody, Nobody, 0) | ::setresuid(Nobody, Nobody, 0), 0);
        }
    }
    ~Unprivileged() {
        if (m_wasRoot) {
            EXPECT_EQ(::setresuid(0, 0, 0) | ::setresgid(0, 0, 0), 0);
        }
    }
    Unprivileged(const Unprivileged&) = delete;
    Unprivileged& operator=(const Unprivileged&) = delete;

private:
    static constexpr unsigned Nobody = 65534;

    static void allow(const std::filesystem::path& path) {
        using std::filesystem::perms;
        std::filesystem::permissions(path, perms::all);
    }

    bool m_wasRoot = ::geteuid() == 0;
};

} // namespace halbench::devices
