#include "devices/open/device_watcher.h"
#include "devices/open/system_files.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <filesystem>
#include <mutex>

namespace halbench::devices {
namespace {

/// What a watcher told, and what it is shown.
class Watched {
public:
    std::vector<DeviceListing> list() {
        const std::lock_guard lock(m_mutex);
        ++m_looks;
        m_changed.notify_all();
        return m_present;
    }
    void plugIn(const std::string& uri) {
        const std::lock_guard lock(m_mutex);
        m_present.emplace_back().uri = uri;
    }
    void note(const std::vector<DeviceListing>& list) {
        const std::lock_guard lock(m_mutex);
        m_told.push_back(list.size());
        m_changed.notify_all();
    }
    std::vector<std::size_t> toldAfter(std::size_t count) {
        std::unique_lock lock(m_mutex);
        m_changed.wait_for(lock, std::chrono::seconds(5), [&] { return m_told.size() >= count; });
        return m_told;
    }
    void awaitLooks(int more) {
        std::unique_lock lock(m_mutex);
        const int wanted = m_looks + more;
        m_changed.wait_for(lock, std::chrono::seconds(5), [&] { return m_looks >= wanted; });
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::vector<DeviceListing> m_present;
    std::vector<std::size_t> m_told;
    int m_looks = 0;
};

TEST(DeviceWatcher, tellsTheListAtTheBeginningAndOnlyWhenItChanged) {
    Watched watched;
    {
        const DeviceWatcher watcher([&](const auto& list) { watched.note(list); },
                                    [&] { return watched.list(); }, 0.005);
        EXPECT_EQ(watched.toldAfter(1), (std::vector<std::size_t>{0}));
        watched.awaitLooks(3);
        watched.plugIn("serial:/dev/ttyACM0");
        EXPECT_EQ(watched.toldAfter(2), (std::vector<std::size_t>{0, 1}));
        watched.awaitLooks(3);
    }
    EXPECT_EQ(watched.toldAfter(0).size(), 2U);
}

TEST(DeviceWatcher, endsAtOnceWhateverItWaitsFor) {
    Watched watched;
    const DeviceWatcher watcher([&](const auto& list) { watched.note(list); }, [&] { return watched.list(); },
                                3600.0);
    EXPECT_EQ(watched.toldAfter(1).size(), 1U);
}

TEST(DeviceListing, beginsWithTheSimulatedDevices) {
    const std::vector<DeviceListing> devices = listDevices();
    ASSERT_FALSE(devices.empty());
    EXPECT_EQ(devices.front().uri, "sim:htm");
    EXPECT_TRUE(devices.front().isAvailable);
    for (const DeviceListing& listing : devices) {
        EXPECT_EQ(listing.isAvailable, listing.reason.empty()) << listing.uri;
    }
}

TEST(SystemFiles, theRulesGrantAccessAndSayHowTheyAreInstalled) {
    const std::string rules = udevRules();
    for (const char* part : {"SUBSYSTEM==\"usb\"", "SUBSYSTEM==\"hidraw\"", "SUBSYSTEM==\"tty\"", "uaccess",
                             "/etc/udev/rules.d/70-halbench.rules", "ID_MM_DEVICE_IGNORE"}) {
        EXPECT_NE(rules.find(part), std::string::npos) << part;
    }
}

TEST(SystemFiles, theMenuEntryStartsThisProgramWhereverItIs) {
    const std::string entry = desktopFile();
    EXPECT_EQ(entry.rfind("[Desktop Entry]\nType=Application\n", 0), 0U);
    const auto self = std::filesystem::read_symlink("/proc/self/exe").string();
    EXPECT_NE(entry.find("\nExec=\"" + self + "\"\n"), std::string::npos) << entry;
}

} // namespace
} // namespace halbench::devices
