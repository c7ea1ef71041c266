#include "tests/conformance/ports/mock_usb.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <array>
#include <filesystem>

namespace halbench::devices {

namespace fs = std::filesystem;

std::string MockMachine::pathOf(const std::string& node) const {
    gchar* root = umockdev_testbed_get_root_dir(m_testbed.get());
    std::string path = root + node;
    g_free(root);
    return path;
}

MockNode::MockNode(const MockMachine& machine, std::string node)
    : m_machine(&machine), m_node(std::move(node)),
      m_master(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)),
      m_handler(umockdev_ioctl_base_new()) {
    EXPECT_EQ(::grantpt(m_master.number()) | ::unlockpt(m_master.number()), 0);
    std::array<char, 128> path{};
    EXPECT_EQ(::ptsname_r(m_master.number(), path.data(), path.size()), 0);
    m_slave = Descriptor(::ioctl(m_master.number(), TIOCGPTPEER, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    EXPECT_TRUE(m_slave.isOpen());
    termios settings{};
    ::tcgetattr(m_slave.number(), &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(m_slave.number(), TCSANOW, &settings);
    const fs::path place = machine.pathOf(m_node);
    fs::create_directories(place.parent_path());
    fs::create_symlink(path.data(), place);
    g_signal_connect(m_handler.get(), "handle-ioctl", G_CALLBACK(&MockNode::ioctlCalled), this);
    g_signal_connect(m_handler.get(), "handle-read", G_CALLBACK(&MockNode::readCalled), this);
    g_signal_connect(m_handler.get(), "handle-write", G_CALLBACK(&MockNode::writeCalled), this);
    EXPECT_TRUE(umockdev_testbed_attach_ioctl(machine.testbed(), m_node.c_str(), m_handler.get(), nullptr));
}

MockNode::~MockNode() {
    umockdev_testbed_detach_ioctl(m_machine->testbed(), m_node.c_str(), nullptr);
    std::error_code error;
    fs::remove(m_machine->pathOf(m_node), error);
}

gboolean MockNode::ioctlCalled(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    return static_cast<MockNode*>(self)->onIoctl(client) ? TRUE : FALSE;
}

gboolean MockNode::readCalled(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    return static_cast<MockNode*>(self)->onRead(client) ? TRUE : FALSE;
}

gboolean MockNode::writeCalled(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    return static_cast<MockNode*>(self)->onWrite(client) ? TRUE : FALSE;
}

} // namespace halbench::devices
