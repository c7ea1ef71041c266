#include "app/wizards/identify_form.h"

#include "control/base/unit_text.h"
#include "widgets/icons.h"
#include "widgets/optional_number_edit.h"
#include "widgets/quantity_edit.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>

#include <limits>

namespace halbench::app {
namespace {

struct GivenConstant {
    const char* symbol; ///< of setGivenConstant()
    const char* unit;
    bool mayBeZero;
};
constexpr std::array GivenAll = {GivenConstant{"J", "kg*m^2", false}, GivenConstant{"c", "N*m*s/rad", true},
                                 GivenConstant{"Kf", "N*m", true}, GivenConstant{"phi", "N*m/A", false}};

/// 0, 1: from, to; 2: step.
widgets::QuantityFormat currentFormat(std::size_t i, double limit_A) {
    const double least_A = i == 2 ? 0.05 : 0.1;
    return {{}, least_A, limit_A, least_A, 2};
}

/// A field with its unit behind it.
QWidget* withUnit(QWidget* field, const char* unit, QWidget* parent) {
    auto* row = new QWidget(parent);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(widgets::PanelMargin_px);
    auto* label = new QLabel(QString::fromStdString(unitText(unit)), row);
    widgets::setRole(*label, widgets::Role::Muted);
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(QStringLiteral("N\u00b7m\u00b7s/rad")));
    layout->addWidget(field, 1);
    layout->addWidget(label);
    return row;
}

} // namespace

IdentifyForm::IdentifyForm(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this)) {
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setSpacing(widgets::GridStep_px);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    buildSweep();
    buildGiven();
    refreshWords();
}

void IdentifyForm::buildSweep() {
    const IdentifyConfig defaults;
    const double starts[] = {defaults.sweep.from_A, defaults.sweep.to_A, defaults.sweep.step_A};
    const auto addRow = [this](QWidget* field) {
        m_labels.push_back(new QLabel(this));
        m_labels.back()->setBuddy(field);
        return m_labels.back();
    };
    for (std::size_t i = 0; i < m_currents.size(); ++i) {
        auto* box = new widgets::QuantityEdit(this);
        box->setFormat(currentFormat(i, m_limit_A));
        box->setQuantity(starts[i]);
        m_form->addRow(addRow(box), withUnit(box, "A", this));
        m_currents[i] = box;
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
    m_directions = new QComboBox(this);
    m_form->addRow(addRow(m_directions), m_directions);
    for (int i = 0; i < 3; ++i) {
        m_directions->addItem({});
    }
    connect(m_directions, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &IdentifyForm::changed);
}

void IdentifyForm::buildGiven() {
    for (std::size_t i = 0; i < m_given.size(); ++i) {
        auto* edit = new widgets::OptionalNumberEdit(this);
        edit->setLimits({0.0, 1e6, GivenAll[i].mayBeZero});
        edit->setObjectName(QString::fromLatin1(GivenAll[i].symbol));
        m_labels.push_back(new QLabel(this));
        m_labels.back()->setBuddy(edit);
        m_form->addRow(m_labels.back(), withUnit(edit, GivenAll[i].unit, this));
        connect(edit, &widgets::OptionalNumberEdit::valueChanged, this, &IdentifyForm::changed);
        m_given[i] = edit;
    }
    m_advanced = new QToolButton(this);
    m_advanced->setAutoRaise(true);
    m_advanced->setCheckable(true);
    m_advanced->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_advanced->setIcon(widgets::themedIcon(QStringLiteral("settings")));
    m_form->addRow(m_advanced);
    m_seed = new QSpinBox(this);
    m_seed->setRange(0, std::numeric_limits<int>::max());
    m_seed->setValue(1);
    m_seed->setAlignment(Qt::AlignRight);
    m_labels.push_back(new QLabel(this));
    m_labels.back()->setBuddy(m_seed);
    m_form->addRow(m_labels.back(), m_seed);
    const auto showAdvanced = [this](bool isShown) {
        m_seed->setVisible(isShown);
        m_labels.back()->setVisible(isShown);
    };
    connect(m_advanced, &QToolButton::toggled, this, showAdvanced);
    connect(m_seed, QOverload<int>::of(&QSpinBox::valueChanged), this, &IdentifyForm::changed);
    showAdvanced(false);
}

void IdentifyForm::refreshWords() {
    const QString names[] = {tr("F&rom current"),
                             tr("T&o current"),
                             tr("Ste&p"),
                             tr("&Directions"),
                             tr("Given inertia &J"),
                             tr("Given dampi&ng c"),
                             tr("Given friction &K_f"),
                             tr("Given torque constant \u03c6"),
                             tr("&Seed")};
    const QString helps[] = {
        tr("First steady current of the sweep; well above the breakaway current"),
        tr("Last steady current of the sweep, included"),
        tr("Distance of the currents"),
        tr("Both ways also tell how friction differs between them"),
        tr("Known inertia of all that turns; makes absolute values of ratios. Empty: not known"),
        tr("Known viscous damping. Empty: not known"),
        tr("Known Coulomb friction. Empty: not known"),
        tr("Known torque constant. Empty: not known"),
        tr("Order of the plateaus and resampling; equal seeds give equal results")};
    const auto fieldOf = [this](std::size_t i) -> QWidget* { return m_labels[i]->buddy(); };
    for (std::size_t i = 0; i < m_labels.size(); ++i) {
        m_labels[i]->setText(names[i]);
        fieldOf(i)->setAccessibleName(QString(names[i]).remove(QLatin1Char('&')));
        if (auto* edit = qobject_cast<widgets::OptionalNumberEdit*>(fieldOf(i))) {
            edit->setExplanation(helps[i]);
            edit->setPlaceholderText(tr("not given"));
        } else if (const auto* box = qobject_cast<widgets::QuantityEdit*>(fieldOf(i))) {
            fieldOf(i)->setToolTip(helps[i] + QLatin1Char('\n') + box->allowedText());
        } else {
            fieldOf(i)->setToolTip(helps[i]);
        }
    }
    const QString directions[] = {tr("both"), tr("forward"), tr("reverse")};
    for (int i = 0; i < 3; ++i) {
        m_directions->setItemText(i, directions[i]);
    }
    m_advanced->setText(tr("&Advanced"));
    m_advanced->setToolTip(tr("Show what is seldom changed (Alt+A)"));
    m_advanced->setAccessibleName(tr("Advanced settings"));
}

Result<IdentifyConfig> IdentifyForm::config() const {
    for (std::size_t i = 0; i < m_currents.size(); ++i) {
        const widgets::QuantityEdit& box = *m_currents[i];
        const QString problem = box.problem().isEmpty() ? m_refused[i] : box.problem();
        if (!problem.isEmpty()) { // the field shows the number before again, and nothing moves by that
            return failure(ErrorCode::InvalidInput,
                           tr("%1: %2").arg(box.accessibleName(), problem).toStdString(),
                           tr("Write the current anew").toStdString());
        }
    }
    IdentifyConfig config;
    config.sweep = {m_currents[0]->value(), m_currents[1]->value(), m_currents[2]->value()};
    config.directions = static_cast<SweepDirections>(m_directions->currentIndex());
    config.seed = static_cast<std::uint64_t>(m_seed->value());
    for (std::size_t i = 0; i < m_given.size(); ++i) {
        const widgets::OptionalNumberEdit& edit = *m_given[i];
        if (!edit.isValid()) {
            return failure(ErrorCode::InvalidInput,
                           tr("%1: %2").arg(edit.accessibleName(), edit.problem()).toStdString(),
                           tr("Correct it or leave it empty").toStdString());
        }
        if (edit.value()) {
            if (auto set = setGivenConstant(config.given, GivenAll[i].symbol, *edit.value()); !set) {
                return failure(set.error());
            }
        }
    }
    if (const auto currents = sweepCurrents_A(config.sweep, m_limit_A); !currents) {
        return failure(currents.error());
    }
    return config;
}

std::map<std::string, double> IdentifyForm::given() const {
    std::map<std::string, double> given;
    for (std::size_t i = 0; i < m_given.size(); ++i) {
        if (const std::optional<double> value = m_given[i]->value()) {
            given[GivenAll[i].symbol] = *value;
        }
    }
    return given;
}

void IdentifyForm::setGiven(const std::map<std::string, double>& given) {
    for (std::size_t i = 0; i < m_given.size(); ++i) {
        const auto found = given.find(GivenAll[i].symbol);
        m_given[i]->setValue(found != given.end() ? std::optional(found->second) : std::nullopt);
    }
}

void IdentifyForm::setCurrentLimit_A(double limit_A) {
    if (limit_A == m_limit_A) {
        return; // a new format would take away what is being typed
    }
    m_limit_A = limit_A;
    for (std::size_t i = 0; i < m_currents.size(); ++i) {
        m_currents[i]->setFormat(currentFormat(i, limit_A));
    }
    refreshWords();
}

void IdentifyForm::setSeed(std::uint64_t seed) {
    m_seed->setValue(static_cast<int>(std::min<std::uint64_t>(seed, std::numeric_limits<int>::max())));
}

void IdentifyForm::focusConstant(const QString& symbol) {
    for (std::size_t i = 0; i < m_given.size(); ++i) {
        if (symbol == QLatin1String(GivenAll[i].symbol)) {
            m_given[i]->setFocus(Qt::OtherFocusReason);
        }
    }
}

void IdentifyForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        refreshWords();
    }
}

} // namespace halbench::app
