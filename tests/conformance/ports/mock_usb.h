#pragma once

#include "devices/transport/descriptor.h"

#include <umockdev.h>

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace halbench::devices {

using Octets = std::vector<std::uint8_t>;

struct GObjectDeleter {
    void operator()(void* object) const { g_object_unref(object); }
};

/// A machine with no hardware but what a test plugs in.
class MockMachine {
public:
    MockMachine() : m_testbed(umockdev_testbed_new()) {}
    UMockdevTestbed* testbed() const { return m_testbed.get(); }
    /// "/dev/x" is a pseudo terminal: poll() of the program sees what its other end does.
    std::string pathOf(const std::string& node) const;

private:
    std::unique_ptr<UMockdevTestbed, GObjectDeleter> m_testbed;
};

/// A device node of the mock machine whose reads, writes and questions a test answers. Thread: the answers
/// are given in umockdev's own.
class MockNode {
public:
    MockNode(const MockMachine& machine, std::string node);
    virtual ~MockNode();
    MockNode(const MockNode&) = delete;
    MockNode& operator=(const MockNode&) = delete;

    const std::string& node() const { return m_node; }

protected:
    virtual bool onIoctl(UMockdevIoctlClient* client) = 0;
    virtual bool onRead(UMockdevIoctlClient* client) = 0;
    virtual bool onWrite(UMockdevIoctlClient* client) = 0;

    /// The pseudo terminal's ends: the program has opened `slave` too.
    const Descriptor& slave() const { return m_slave; }
    Descriptor& master() { return m_master; }
    /// The program's poll() sees a hang-up.
    void hangUp() { m_master.close(); }

    std::mutex m_mutex;

private:
    static gboolean ioctlCalled(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    static gboolean readCalled(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    static gboolean writeCalled(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);

    const MockMachine* m_machine;
    std::string m_node;
    Descriptor m_master;
    Descriptor m_slave;
    std::unique_ptr<UMockdevIoctlBase, GObjectDeleter> m_handler;
};

/// How a bulk board presents itself.
struct BulkTraits {
    std::string driver{}; ///< the kernel driver that holds its interface
    std::string vendor = "1209";
    std::string product = "0001";
    std::string interfaceClass = "ff";
    bool hasSecondPair = false; ///< 0x83 and 0x04 behind 0x81 and 0x02
    bool isDetachable = true;   ///< its driver lets go
    bool answersCancel = true;  ///< else cancelled transfers never come back
    int submitError = 0;        ///< of every transfer
};

/// A board with a pair of bulk endpoints, plugged in while it lives.
class MockBulkBoard : public MockNode {
public:
    /// How the system tells the program that the device is gone: both are seen on real machines.
    enum class Departure { NoDevice, ProtocolError };

    MockBulkBoard(const MockMachine& machine, int address, const std::string& serial, BulkTraits traits = {});
    ~MockBulkBoard() override;

    void deliver(const Octets& octets);
    /// What the program sent, taken; waits up to 2 s until it is this much.
    Octets taken(std::size_t count);
    /// What the program sent, taken; waits so long for the first octet.
    Octets takenWithin(double time_s);
    void setStalled(bool isStalled); ///< takes nothing any more
    /// Its endpoints answer STALL until each is cleared.
    void halt();
    /// Whom the interface belongs to now: a kernel driver, or nobody.
    std::string driver();
    bool isClaimed();
    std::vector<std::uint8_t> usedEnds(); ///< endpoint addresses in order of their first use
    void unplug(Departure departure);

protected:
    bool onIoctl(UMockdevIoctlClient* client) override;
    bool onRead(UMockdevIoctlClient*) override { return false; }
    bool onWrite(UMockdevIoctlClient*) override { return false; }

private:
    /// A transfer of the program: usbfs's block and the octets it points to, both resolved when it was
    /// submitted.
    struct Transfer {
        UMockdevIoctlData* block = nullptr;
        UMockdevIoctlData* octets = nullptr;
    };

    void submit(UMockdevIoctlClient* client);
    void reap(UMockdevIoctlClient* client);
    void discard(UMockdevIoctlClient* client);
    void tellDriver(UMockdevIoctlClient* client);
    void changeDriver(UMockdevIoctlClient* client);
    void clearHalt(UMockdevIoctlClient* client);
    bool isHalted(std::uint8_t end) const;
    void noteUse(std::uint8_t end);
    void fillWaiting();
    void finish(const Transfer& transfer, int status);
    void showReady();

    const MockMachine* m_machine;
    BulkTraits m_traits;
    std::string m_place;
    std::string m_driver;
    std::vector<std::uint8_t> m_halted;
    std::vector<std::uint8_t> m_usedEnds;
    std::deque<Transfer> m_waiting; ///< for octets of the board
    std::deque<Transfer> m_stuck;   ///< to a board that takes nothing
    std::deque<Transfer> m_done;
    std::deque<Octets> m_toHost;
    Octets m_fromHost;
    std::condition_variable m_changed;
    bool m_isStalled = false;
    bool m_isClaimed = false;
    bool m_isGone = false;
};

/// A board that speaks in HID reports.
class MockHidBoard : public MockNode {
public:
    MockHidBoard(const MockMachine& machine, int number, const std::string& serial);
    ~MockHidBoard() override;

    void deliver(const Octets& report);
    std::vector<Octets> taken(std::size_t count);
    std::vector<Octets> takenWithin(double time_s);
    /// It takes no report any more: the system holds whoever writes one, and refuses it in the end.
    void setStalled(bool isStalled);
    void unplug();

protected:
    bool onIoctl(UMockdevIoctlClient* client) override;
    bool onRead(UMockdevIoctlClient* client) override;
    bool onWrite(UMockdevIoctlClient* client) override;

private:
    const MockMachine* m_machine;
    std::vector<std::string> m_places; ///< in the device tree, the parents first
    std::deque<Octets> m_toHost;
    std::vector<Octets> m_fromHost;
    std::vector<UMockdevIoctlClient*> m_held; ///< writers without an answer
    std::condition_variable m_changed;
    bool m_isStalled = false;
    bool m_isGone = false;

    void release(int error);
};

} // namespace halbench::devices
