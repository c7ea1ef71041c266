#include "devices/xcp/board_description.h"

#include <algorithm>
#include <cmath>

namespace halbench::devices::xcp {

namespace {

// Transaction marks belong to the link, not to the user (3.16).
constexpr const char* FirstMark = "set.first";
constexpr const char* LastMark = "set.last";
constexpr std::int64_t MaxChoices = 1024;

std::vector<std::string> choicesOf(const A2lConversion& conversion) {
    std::vector<std::string> choices;
    for (const auto& [value, word] : conversion.words) {
        if (value < 0 || value > MaxChoices) {
            continue;
        }
        choices.resize(static_cast<std::size_t>(value) + 1);
        choices[static_cast<std::size_t>(value)] = word;
    }
    return choices;
}

double rateOf(double cycle_s) {
    return cycle_s > 0.0 ? 1.0 / cycle_s : 0.0;
}

std::map<std::uint16_t, double> eventRatesOf(const A2lDescription& a2l,
                                             const std::optional<DaqAbility>& ability) {
    std::map<std::uint16_t, double> rates;
    for (const A2lEvent& event : a2l.events) {
        rates[event.number] = rateOf(event.cycle_s);
    }
    if (ability) {
        for (std::size_t i = 0; i < ability->eventCycles_s.size(); ++i) {
            rates[static_cast<std::uint16_t>(i)] = rateOf(ability->eventCycles_s[i]);
        }
    }
    return rates;
}

} // namespace

BoardDescription::BoardDescription(A2lDescription description, const std::optional<DaqAbility>& ability)
    : m_a2l(std::move(description)), m_eventRates_Hz(eventRatesOf(m_a2l, ability)) {
    for (std::size_t i = 0; i < m_a2l.measurements.size(); ++i) {
        m_measurements[m_a2l.measurements[i].name] = i;
        addSignal(m_a2l.measurements[i]);
    }
    for (std::size_t i = 0; i < m_a2l.characteristics.size(); ++i) {
        m_characteristics[m_a2l.characteristics[i].name] = i;
        addParameter(m_a2l.characteristics[i]);
    }
    nameGroups();
}

void BoardDescription::addSignal(const A2lMeasurement& measurement) {
    if (measurement.count != 1) {
        return;
    }
    SignalSpec spec;
    spec.name = measurement.name;
    spec.unit = measurement.conversion.unit;
    spec.min = measurement.lower;
    spec.max = measurement.upper;
    spec.help = measurement.help;
    spec.choices = choicesOf(measurement.conversion);
    for (const auto& [event, rate_Hz] : eventRates(measurement)) {
        spec.maxRate_Hz = std::max(spec.maxRate_Hz, rate_Hz);
        spec.events.push_back(event);
    }
    m_catalogue.signals.push_back(std::move(spec));
}

void BoardDescription::addParameter(const A2lCharacteristic& characteristic) {
    const bool isMark = characteristic.name == FirstMark || characteristic.name == LastMark;
    if (characteristic.count != 1 || characteristic.kind != A2lCharacteristicKind::Value || isMark) {
        return;
    }
    ParameterSpec spec;
    spec.name = characteristic.name;
    spec.unit = characteristic.conversion.unit;
    spec.min = characteristic.lower;
    spec.max = characteristic.upper;
    spec.choices = choicesOf(characteristic.conversion);
    const bool isWhole = characteristic.conversion.factor == std::floor(characteristic.conversion.factor) &&
                         characteristic.conversion.offset == std::floor(characteristic.conversion.offset);
    spec.isInteger = (!isFloat(characteristic.type) && isWhole) || !spec.choices.empty();
    spec.isTransactional = switchableSegment(characteristic) != nullptr;
    spec.access = characteristic.isReadOnly ? ParameterAccess::ReadOnly : ParameterAccess::ReadWrite;
    spec.help = characteristic.help;
    m_catalogue.parameters.push_back(std::move(spec));
}

void BoardDescription::nameGroups() {
    std::map<std::string, std::string> groupOf;
    for (const A2lGroup& group : m_a2l.groups) {
        for (const std::string& member : group.members) {
            groupOf.emplace(member, group.name);
        }
    }
    for (ParameterSpec& spec : m_catalogue.parameters) {
        const auto found = groupOf.find(spec.name);
        // Without a group in the description the part before the first dot is one.
        spec.group = found != groupOf.end() ? found->second : spec.name.substr(0, spec.name.find('.'));
    }
}

void BoardDescription::makeReadOnly(const A2lSegment& segment) {
    for (ParameterSpec& spec : m_catalogue.parameters) {
        const A2lCharacteristic* object = characteristic(spec.name);
        if (segment.contains(object->address, sizeOf(object->type) * object->count)) {
            spec.access = ParameterAccess::ReadOnly;
        }
    }
}

const A2lMeasurement* BoardDescription::measurement(const std::string& name) const {
    const auto found = m_measurements.find(name);
    return found == m_measurements.end() ? nullptr : &m_a2l.measurements[found->second];
}

const A2lCharacteristic* BoardDescription::characteristic(const std::string& name) const {
    const auto found = m_characteristics.find(name);
    return found == m_characteristics.end() ? nullptr : &m_a2l.characteristics[found->second];
}

const A2lSegment* BoardDescription::switchableSegment(const A2lCharacteristic& characteristic) const {
    for (const A2lSegment& segment : m_a2l.segments) {
        if (segment.hasTwoWritablePages() &&
            segment.contains(characteristic.address, sizeOf(characteristic.type) * characteristic.count)) {
            return &segment;
        }
    }
    return nullptr;
}

std::optional<TransactionMarks> BoardDescription::marks(const A2lSegment& segment) const {
    const A2lCharacteristic* first = characteristic(FirstMark);
    const A2lCharacteristic* last = characteristic(LastMark);
    const auto isMark = [&](const A2lCharacteristic* mark) {
        return mark != nullptr && mark->type == DataType::ULong && segment.contains(mark->address, 4);
    };
    if (!isMark(first) || !isMark(last)) {
        return std::nullopt;
    }
    return TransactionMarks{first->address.offset - segment.address.offset,
                            last->address.offset - segment.address.offset};
}

std::string BoardDescription::parameterAt(const A2lSegment& segment, std::uint32_t offset) const {
    const Address place{segment.address.offset + offset, segment.address.extension};
    for (const A2lCharacteristic& object : m_a2l.characteristics) {
        const std::size_t octets = sizeOf(object.type) * object.count;
        if (object.address.extension == place.extension && place.offset >= object.address.offset &&
            place.offset < object.address.offset + octets) {
            return object.name;
        }
    }
    return {};
}

std::map<std::uint16_t, double> BoardDescription::eventRates(const A2lMeasurement& measurement) const {
    if (measurement.events.empty()) {
        return m_eventRates_Hz;
    }
    std::map<std::uint16_t, double> rates;
    for (const std::uint16_t event : measurement.events) {
        if (const auto found = m_eventRates_Hz.find(event); found != m_eventRates_Hz.end()) {
            rates.insert(*found);
        }
    }
    return rates;
}

} // namespace halbench::devices::xcp
