#pragma once

#include <initializer_list>
#include <span>

namespace halbench::app {

/// A number of the board's reference generator that a user gives.
enum class ReferenceField {
    Amplitude,
    Rate,
    Frequency,
    FrequencyEnd,
    Period,
    Count,
    Base,
    Seed,
    Duration,
    Dwell
};

struct ReferenceRange {
    double min, max, initial, step;
    int decimals;
};

/// Texts and limits of a field; words in the translator's context of ReferenceForm.
struct ReferenceFieldSpec {
    ReferenceField field;
    const char* title;
    const char* help;
    const char* angleUnit; ///< SI, in position mode
    const char* currentUnit;
    ReferenceRange angle; ///< of angles and speeds in degrees
    ReferenceRange current;
    const char* currentTitle = nullptr; ///< in the other modes, where it is another
};

/// In the order of the form. The limits are the board's: resources/help/protocol.md 3.15.
std::span<const ReferenceFieldSpec> referenceFields();
const ReferenceFieldSpec& referenceField(ReferenceField field);
/// An angle or a speed, a current in the other modes.
bool isAngular(ReferenceField field);

struct ReferenceShape {
    const char* title;
    std::initializer_list<ReferenceField> fields;
};

/// The board's codes are 1 ... 7; the last are plateaus, which have currents besides.
constexpr int PlateausShape = 7;
const ReferenceShape& referenceShape(int code);
bool hasField(int code, ReferenceField field);

} // namespace halbench::app
