#include "app/wizards/frequency_form.h"

#include "control/base/units.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/theme/theme_style.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>

#include <cmath>

namespace halbench::app {
namespace {

struct NumberField {
    double start;
    widgets::QuantityFormat format;
    const char* unit;
};

std::array<NumberField, 5> numberFields() {
    const FrequencyConfig defaults;
    return {NumberField{defaults.from_Hz, {{}, 0.1, 100.0, 0.5, 2}, "Hz"},
            NumberField{defaults.to_Hz, {{}, 0.2, 200.0, 1.0, 2}, "Hz"},
            NumberField{defaults.base_rad_s, {{}, -100.0, 100.0, 1.0, 2}, "rad/s"},
            NumberField{static_cast<double>(defaults.periods), {{}, 4.0, 64.0, 1.0, 0}, ""},
            NumberField{defaults.leastCoherence, {{}, 0.5, 0.999, 0.05, 3}, ""}};
}

} // namespace

FrequencyForm::FrequencyForm(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this)) {
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setSpacing(widgets::GridStep_px);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_excitation = new QComboBox(this);
    m_excitation->setObjectName(QStringLiteral("excitation"));
    for (const Excitation each : {Excitation::Multisine, Excitation::SteppedSine, Excitation::Chirp}) {
        m_excitation->addItem({}, static_cast<int>(each));
    }
    addRow(m_excitation, {});
    connect(m_excitation, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &FrequencyForm::changed);
    buildNumbers();
    m_amplitude_deg = new widgets::OptionalNumberEdit(this);
    m_amplitude_deg->setObjectName(QStringLiteral("amplitude"));
    m_amplitude_deg->setLimits({1e-3, 57.0, true});
    addRow(m_amplitude_deg, QStringLiteral("\u00b0"));
    connect(m_amplitude_deg, &widgets::OptionalNumberEdit::valueChanged, this, &FrequencyForm::changed);
    refreshWords();
}

void FrequencyForm::addRow(QWidget* field, const QString& unit) {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(widgets::PanelMargin_px);
    auto* behind = new QLabel(unit, row);
    widgets::setRole(*behind, widgets::Role::Muted);
    behind->setMinimumWidth(behind->fontMetrics().horizontalAdvance(QStringLiteral("rad/s ")));
    layout->addWidget(field, 1);
    layout->addWidget(behind);
    auto* label = new QLabel(this);
    label->setBuddy(field);
    m_labels.push_back(label);
    m_form->addRow(label, row);
}

void FrequencyForm::buildNumbers() {
    const auto fields = numberFields();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        auto* box = new widgets::QuantityEdit(this);
        box->setFormat(fields[i].format);
        box->setQuantity(fields[i].start);
        addRow(box, QString::fromLatin1(fields[i].unit));
        m_numbers[i] = box;
        const auto take = [this, i](const QString& refused) {
            m_refused[i] = refused;
            Q_EMIT changed();
        };
        connect(box, &widgets::QuantityEdit::edited, this, [take] { take({}); });
        connect(box, &widgets::QuantityEdit::entered, this, [take] { take({}); });
        connect(box, &widgets::QuantityEdit::refused, this,
                [take, box](const QString& text) { take(box->problemOf(text)); });
        connect(box->findChild<QLineEdit*>(), &QLineEdit::textEdited, this, [take] { take({}); });
    }
}

void FrequencyForm::refreshWords() {
    const QString excitations[] = {tr("multisine: all frequencies together"),
                                   tr("stepped sine: one frequency at a time"), tr("chirp: repeated sweeps")};
    for (int i = 0; i < m_excitation->count(); ++i) {
        m_excitation->setItemText(i, excitations[i]);
    }
    const QString names[] = {tr("E&xcitation"), tr("Lowest frequency"), tr("Highest frequency"),
                             tr("&Base speed"), tr("&Periods"),         tr("Minimum coherence"),
                             tr("Amplitude")};
    const QString helps[] = {
        tr("Signal added to the steady motion"),
        tr("One excitation period lasts four periods of this frequency"),
        tr("At most 45 % of the position loop's sampling rate"),
        tr("Steady speed, at least 3 rad/s in either direction, so that friction acts as a constant offset"),
        tr("Periods (chirp: sweeps) to average; the intervals shrink with the square root"),
        tr("Points below it are shown faint and not used for margins and fit"),
        tr("Amplitude of a sine of the same rms in each band. Empty: maximum safe value")};
    for (std::size_t i = 0; i < m_labels.size(); ++i) {
        QWidget* field = m_labels[i]->buddy();
        m_labels[i]->setText(names[i]);
        field->setAccessibleName(QString(names[i]).remove(QLatin1Char('&')));
        field->setAccessibleDescription(helps[i]);
        const auto* box = qobject_cast<widgets::QuantityEdit*>(field);
        field->setToolTip(box != nullptr ? helps[i] + QLatin1Char('\n') + box->allowedText() : helps[i]);
    }
    m_amplitude_deg->setExplanation(helps[6]);
    m_amplitude_deg->setPlaceholderText(tr("maximum safe value"));
}

Result<FrequencyConfig> FrequencyForm::config() const {
    const auto refuse = [](const QWidget& field, const QString& problem) {
        return failure(ErrorCode::InvalidInput,
                       tr("%1: %2").arg(field.accessibleName(), problem).toStdString(),
                       tr("Enter the number again").toStdString());
    };
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        const QString problem = m_numbers[i]->problem().isEmpty() ? m_refused[i] : m_numbers[i]->problem();
        if (!problem.isEmpty()) { // the field shows the number before again, and nothing moves by that
            return refuse(*m_numbers[i], problem);
        }
    }
    if (!m_amplitude_deg->isValid()) {
        return refuse(*m_amplitude_deg, m_amplitude_deg->problem());
    }
    FrequencyConfig config;
    config.excitation = static_cast<Excitation>(m_excitation->currentData().toInt());
    config.from_Hz = m_numbers[From]->value();
    config.to_Hz = m_numbers[To]->value();
    config.base_rad_s = m_numbers[Base]->value();
    config.periods = static_cast<int>(std::lround(m_numbers[Periods]->value()));
    config.leastCoherence = m_numbers[Coherence]->value();
    if (const auto amplitude_deg = m_amplitude_deg->value()) {
        config.amplitude_rad = degreesToRadians(*amplitude_deg);
    }
    return config;
}

void FrequencyForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
