#include "tests/devices/firmware/avr/simavr/avr_core.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

extern "C" {
#include <simavr/avr_adc.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_twi.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
}

namespace halbench::simavr {
namespace {

constexpr std::uint32_t RamStart = 0x100;
constexpr std::uint8_t Paint = 0xA5;
/// Ten bits at 115200 Bd.
constexpr avr_cycle_count_t CyclesPerOctet = 1389;

void sleepNotAtAll(avr_t*, avr_cycle_count_t) {}

} // namespace

/// simavr calls functions with a context pointer.
struct AvrCallbacks {
    static void uartOutput(avr_irq_t*, std::uint32_t value, void* context) {
        static_cast<AvrCore*>(context)->m_fromBoard.push_back(static_cast<std::uint8_t>(value));
    }
    static avr_cycle_count_t uartInput(avr_t*, avr_cycle_count_t, void* context) {
        static_cast<AvrCore*>(context)->deliverOctet();
        return 0;
    }
    static void conversion(avr_irq_t*, std::uint32_t value, void* context) {
        auto* core = static_cast<AvrCore*>(context);
        avr_adc_mux_t mux;
        std::memcpy(&mux, &value, sizeof value);
        const int channel = static_cast<int>(mux.src);
        const int code = core->onConversion ? core->onConversion(channel) : 0;
        // simavr takes millivolts and gives floor(mV 1023 / 5000): the lowest voltage of the wanted code.
        const int voltage_mV = (code * 5000 + 1022) / 1023;
        avr_irq_t* pin =
            avr_io_getirq(core->m_avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0 + static_cast<int>(mux.src));
        avr_raise_irq(pin, static_cast<std::uint32_t>(voltage_mV));
    }
    static void twi(avr_irq_t*, std::uint32_t value, void* context) {
        static_cast<AvrCore*>(context)->twiMessage(value);
    }
    static void pin(avr_irq_t*, std::uint32_t value, void* context) {
        auto* core = static_cast<AvrCore*>(context);
        if (core->onPin) {
            core->onPin(value != 0);
        }
    }
};

Result<std::unique_ptr<AvrCore>> AvrCore::load(const std::string& elf) {
    elf_firmware_t program{};
    if (elf_read_firmware(elf.c_str(), &program) != 0) {
        return failure(ErrorCode::InvalidInput, fmt::format("'{}' is no program for this processor", elf),
                       "build it: devices/firmware/boards/htm_atmega328p/build.sh");
    }
    std::unique_ptr<AvrCore> core(new AvrCore);
    core->m_avr = avr_make_mcu_by_name("atmega328p");
    avr_init(core->m_avr);
    core->m_avr->log = LOG_ERROR;
    core->m_avr->frequency = static_cast<std::uint32_t>(Clock_Hz);
    core->m_avr->vcc = core->m_avr->avcc = core->m_avr->aref = 5000;
    core->m_avr->sleep = &sleepNotAtAll;
    avr_load_firmware(core->m_avr, &program);
    core->m_avr->frequency = static_cast<std::uint32_t>(Clock_Hz);
    core->m_sizes = {program.flashsize, program.datasize + program.bsssize};
    std::memset(core->m_avr->data + RamStart + core->m_sizes.ram, Paint,
                core->m_avr->ramend + 1U - RamStart - core->m_sizes.ram);
    std::free(program.flash);
    core->connect();
    return core;
}

AvrCore::~AvrCore() {
    if (m_avr != nullptr) {
        avr_terminate(m_avr);
        std::free(m_avr);
    }
}

void AvrCore::connect() {
    std::uint32_t flags = 0;
    avr_ioctl(m_avr, AVR_IOCTL_UART_GET_FLAGS('0'), &flags);
    flags &= ~static_cast<std::uint32_t>(AVR_UART_FLAG_STDIO | AVR_UART_FLAG_POLL_SLEEP);
    avr_ioctl(m_avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    const auto listen = [this](std::uint32_t control, int index, avr_irq_notify_t callback) {
        avr_irq_register_notify(avr_io_getirq(m_avr, control, index), callback, this);
    };
    listen(AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT, &AvrCallbacks::uartOutput);
    listen(AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER, &AvrCallbacks::conversion);
    listen(AVR_IOCTL_TWI_GETIRQ(0), TWI_IRQ_OUTPUT, &AvrCallbacks::twi);
    listen(AVR_IOCTL_IOPORT_GETIRQ('B'), 5, &AvrCallbacks::pin);
}

std::uint64_t AvrCore::cycle() const {
    return m_avr->cycle;
}

bool AvrCore::isRunning() const {
    return m_avr->state != cpu_Done && m_avr->state != cpu_Crashed;
}

void AvrCore::runTo(std::uint64_t cycle) {
    while (m_avr->cycle < cycle && isRunning()) {
        avr_run(m_avr);
    }
}

void AvrCore::reset() {
    avr_reset(m_avr);
    m_toBoard.clear();
    m_fromBoard.clear();
    m_isOctetScheduled = false;
    m_twiAddress = -1;
}

void AvrCore::send(std::span<const std::uint8_t> octets) {
    m_toBoard.insert(m_toBoard.end(), octets.begin(), octets.end());
    scheduleOctet();
}

void AvrCore::scheduleOctet() {
    if (!m_isOctetScheduled && !m_toBoard.empty()) {
        m_isOctetScheduled = true;
        avr_cycle_timer_register(m_avr, CyclesPerOctet, &AvrCallbacks::uartInput, this);
    }
}

void AvrCore::deliverOctet() {
    m_isOctetScheduled = false;
    if (m_toBoard.empty()) {
        return;
    }
    const std::uint8_t octet = m_toBoard.front();
    m_toBoard.pop_front();
    avr_raise_irq(avr_io_getirq(m_avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT), octet);
    scheduleOctet();
}

std::vector<std::uint8_t> AvrCore::take() {
    std::vector<std::uint8_t> octets;
    octets.swap(m_fromBoard);
    return octets;
}

void AvrCore::twiMessage(std::uint32_t value) {
    avr_twi_msg_irq_t message;
    message.u.v = value;
    bool isAcknowledged = false;
    if ((message.u.twi.msg & TWI_COND_STOP) != 0) {
        m_twiAddress = -1;
    }
    if ((message.u.twi.msg & TWI_COND_START) != 0) {
        const int address = static_cast<int>(message.u.twi.addr) >> 1;
        isAcknowledged = onTwiAddress && onTwiAddress(address);
        m_twiAddress = isAcknowledged ? address : -1;
        m_twiIndex = 0;
    } else if ((message.u.twi.msg & TWI_COND_WRITE) != 0 && m_twiAddress >= 0) {
        isAcknowledged = onTwiOctet && onTwiOctet(m_twiAddress, m_twiIndex++,
                                                  static_cast<std::uint8_t>(message.u.twi.data));
    }
    if (isAcknowledged) {
        avr_raise_irq(avr_io_getirq(m_avr, AVR_IOCTL_TWI_GETIRQ(0), TWI_IRQ_INPUT),
                      avr_twi_irq_msg(TWI_COND_ACK, static_cast<std::uint8_t>(message.u.twi.addr), 1));
    }
}

std::span<std::uint8_t> AvrCore::variables() {
    return {m_avr->data + RamStart, m_sizes.ram};
}

std::uint32_t AvrCore::untouchedRam() const {
    const std::uint8_t* first = m_avr->data + RamStart + m_sizes.ram;
    const std::uint8_t* last = m_avr->data + m_avr->ramend + 1U;
    return static_cast<std::uint32_t>(
        std::find_if(first, last, [](std::uint8_t octet) { return octet != Paint; }) - first);
}

} // namespace halbench::simavr
