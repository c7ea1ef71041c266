#include "app/workspaces/drive/reference_fields.h"

#include <QtGlobal>

#include <algorithm>

namespace halbench::app {

namespace {

using Field = ReferenceField;

constexpr ReferenceRange Frequencies{0.001, 200.0, 1.0, 0.1, 3};

constexpr ReferenceFieldSpec Fields[] = {
    {Field::Amplitude,
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Amplitude"),
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm",
                       "Height of one step (step, staircase), amplitude (sine, chirp), rms (multisine), end "
                       "value (ramp; 0: no end)"),
     "rad",
     "A",
     {-36000.0, 36000.0, 30.0, 1.0, 2},
     {-4.0, 4.0, 0.5, 0.1, 3}},
    {Field::Rate,
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Slope"),
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Slope of the ramp; negative: backward"),
     "rad/s",
     "A/s",
     {-36000.0, 36000.0, 90.0, 10.0, 2},
     {-100.0, 100.0, 0.5, 0.1, 3}},
    {Field::Frequency, QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Frequency"),
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm",
                       "Frequency of the sine; start frequency of chirp and multisine"),
     "Hz", "Hz", Frequencies, Frequencies},
    {Field::FrequencyEnd,
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "End frequency"),
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "End frequency of chirp and multisine"),
     "Hz",
     "Hz",
     {0.001, 200.0, 10.0, 1.0, 3},
     {0.001, 200.0, 10.0, 1.0, 3}},
    {Field::Period,
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Step time"),
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Time of each step"),
     "s",
     "s",
     {0.001, 3600.0, 1.0, 0.1, 3},
     {0.001, 3600.0, 1.0, 0.1, 3}},
    {Field::Count,
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Number of steps"),
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm",
                       "Steps of a staircase, lines of a multisine (max. 32)"),
     "",
     "",
     {1.0, 1000.0, 8.0, 1.0, 0},
     {1.0, 1000.0, 8.0, 1.0, 0}},
    {Field::Seed,
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Seed"),
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Phase seed of the multisine; 0: low crest factor"),
     "",
     "",
     {0.0, 4294967295.0, 0.0, 1.0, 0},
     {0.0, 4294967295.0, 0.0, 1.0, 0}},
    {Field::Base,
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Offset speed (added)"),
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Constant speed or current added to the shape"),
     "rad/s",
     "A",
     {-36000.0, 36000.0, 0.0, 10.0, 2},
     {-4.0, 4.0, 0.0, 0.1, 3},
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Offset current (added)")},
    {Field::Duration,
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Duration"),
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm",
                       "Afterwards a position is held and a current goes to zero"),
     "s",
     "s",
     {0.01, 3600.0, 5.0, 1.0, 2},
     {0.01, 3600.0, 5.0, 1.0, 2}},
    {Field::Dwell,
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Plateau time"),
     QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Time of each current"),
     "s",
     "s",
     {0.01, 3600.0, 2.0, 0.5, 2},
     {0.01, 3600.0, 2.0, 0.5, 2}},
};

} // namespace

std::span<const ReferenceFieldSpec> referenceFields() {
    return Fields;
}

const ReferenceFieldSpec& referenceField(ReferenceField field) {
    return *std::find_if(std::begin(Fields), std::end(Fields),
                         [field](const ReferenceFieldSpec& each) { return each.field == field; });
}

bool isAngular(ReferenceField field) {
    return field == Field::Amplitude || field == Field::Rate || field == Field::Base;
}

const ReferenceShape& referenceShape(int code) {
    static const ReferenceShape shapes[] = {
        {QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Step"),
         {Field::Amplitude, Field::Base, Field::Duration}},
        {QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Ramp"),
         {Field::Rate, Field::Amplitude, Field::Base, Field::Duration}},
        {QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Sine"),
         {Field::Amplitude, Field::Frequency, Field::Base, Field::Duration}},
        {QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Staircase"),
         {Field::Amplitude, Field::Period, Field::Count, Field::Base}},
        {QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Chirp"),
         {Field::Amplitude, Field::Frequency, Field::FrequencyEnd, Field::Base, Field::Duration}},
        {QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Multisine"),
         {Field::Amplitude, Field::Frequency, Field::FrequencyEnd, Field::Count, Field::Seed, Field::Base,
          Field::Duration}},
        {QT_TRANSLATE_NOOP("halbench::app::ReferenceForm", "Speed plateaus"), {Field::Dwell}},
    };
    return shapes[code - 1];
}

bool hasField(int code, ReferenceField field) {
    const auto& fields = referenceShape(code).fields;
    return std::find(fields.begin(), fields.end(), field) != fields.end();
}

} // namespace halbench::app
