#include "devices/transport/port_access.h"
#include "tests/devices/transport/pty_line.h"

#include <fcntl.h>
#include <gtest/gtest.h>

namespace halbench::devices {
namespace {

TEST(PortAccess, aNodeThatIsNotThereSaysWhereToLook) {
    const auto trouble = troubleOf("/dev/no-such-port");
    ASSERT_TRUE(trouble);
    EXPECT_EQ(trouble->reason, "/dev/no-such-port not found");
    EXPECT_NE(trouble->hint.find("halbench devices"), std::string::npos);
    EXPECT_FALSE(troubleOf("/dev/null"));
}

TEST(PortAccess, missingPermissionNamesTheRulesAndTheGroup) {
    const PtyLine line; // pseudo terminals belong to the group tty
    const PortTrouble trouble = permissionTrouble(line.path(), true);
    EXPECT_EQ(trouble.reason, "no permission to use " + line.path());
    EXPECT_NE(trouble.hint.find("--udev-rules"), std::string::npos);
    EXPECT_EQ(permissionTrouble("/dev/null", true).hint.find("usermod"), std::string::npos)
        << "nobody is told to join the group root";
}

TEST(PortAccess, whereNoUdevRunsNobodyIsToldToInstallRules) {
    const PtyLine line;
    const PortTrouble trouble = permissionTrouble(line.path(), false);
    EXPECT_EQ(trouble.reason, "no permission to use " + line.path());
    EXPECT_EQ(trouble.hint.find("--udev-rules"), std::string::npos) << trouble.hint;
    EXPECT_NE(trouble.hint.find("no udev runs here"), std::string::npos) << trouble.hint;
    EXPECT_NE(trouble.hint.find("sudo chmod a+rw " + line.path()), std::string::npos) << trouble.hint;
}

TEST(PortAccess, theHolderOfAPortIsNamed) {
    const PtyLine line;
    EXPECT_FALSE(holderOf(line.path()));
    const Descriptor held(::open(line.path().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    ASSERT_TRUE(held.isOpen());
    EXPECT_EQ(holderOf(line.path()), std::optional<std::string>("this program"));
    EXPECT_EQ(busyTrouble(line.path()).reason, line.path() + " is in use by this program");
    EXPECT_EQ(portError("serial:x", busyTrouble(line.path())).code, ErrorCode::DeviceLost);
}

} // namespace
} // namespace halbench::devices
