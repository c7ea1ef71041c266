#include "devices/recording/disk_access.h"

#include <gtest/gtest.h>

#include <cerrno>

namespace halbench::devices {
namespace {

TEST(DiskAccess, aFullDiskRefusesAtOnce) {
    QFile full("/dev/full"); // a disk without room, always
    ASSERT_TRUE(full.open(QIODevice::WriteOnly));
    EXPECT_FALSE(realDisk().write(full, "rows\n"));
    EXPECT_EQ(errno, ENOSPC);
}

TEST(DiskAccess, aHandleThatIsNoneIsNotFlushed) {
    EXPECT_FALSE(realDisk().sync(-1));
}

} // namespace
} // namespace halbench::devices
