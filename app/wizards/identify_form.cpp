#include "app/wizards/identify_form.h"

#include "control/base/unit_text.h"
#include "widgets/controls/optional_number_edit.h"
#include "widgets/controls/quantity_edit.h"
#include "widgets/theme/icons.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTextDocumentFragment>
#include <QTimer>
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

/// Of what it shows now, whether or not it has been entered.
QString problemNow(const widgets::QuantityEdit& box) {
    return box.problemOf(box.text());
}

/// As a screen reader says it: without access key and mark-up.
QString plainWords(QString words) {
    return QTextDocumentFragment::fromHtml(words.remove(QLatin1Char('&'))).toPlainText();
}

double shown(const widgets::QuantityEdit& box) {
    return problemNow(box).isEmpty() ? box.valueFromText(box.text()) : box.value();
}

} // namespace

IdentifyForm::IdentifyForm(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this)) {
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setSpacing(widgets::GridStep_px);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    buildSweep();
    buildGiven();
    buildAdvanced();
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
        watchCurrent(*box);
    }
    m_directions = new QComboBox(this);
    m_form->addRow(addRow(m_directions), m_directions);
    for (int i = 0; i < 3; ++i) {
        m_directions->addItem({});
    }
    connect(m_directions, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &IdentifyForm::onChange);
}

void IdentifyForm::watchCurrent(widgets::QuantityEdit& box) {
    connect(&box, &widgets::QuantityEdit::edited, this, &IdentifyForm::onChange);
    // After the field's own judgement of it.
    connect(box.findChild<QLineEdit*>(), &QLineEdit::textChanged, this, &IdentifyForm::onChange);
    connect(&box, &widgets::QuantityEdit::refused, this, [this, &box](const QString& text) {
        onChange();
        if (box.text() != text) { // left: it shows the number before
            m_isReverting = true;
            m_notice = tr("%1: '%2' is not valid. %3 Reset to %4 A.")
                           .arg(box.accessibleName(), text, box.problemOf(text), box.text());
            Q_EMIT changed();
            // The click that took the focus was meant for what was typed: it starts nothing, the next one
            // does.
            QTimer::singleShot(0, this, [this] {
                m_isReverting = false;
                Q_EMIT changed();
            });
        }
    });
}

void IdentifyForm::onChange() {
    m_notice.clear();
    markSweep();
    Q_EMIT changed();
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
}

void IdentifyForm::buildAdvanced() {
    m_advanced = new QToolButton(this);
    m_advanced->setAutoRaise(true);
    m_advanced->setCheckable(true);
    m_advanced->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_advanced->setIcon(widgets::themedIcon(QStringLiteral("settings")));
    m_form->addRow(m_advanced);
    m_currentTolerance = new widgets::OptionalNumberEdit(this);
    m_currentTolerance->setLimits({0.0, LargestCurrentTolerance_percent, true});
    m_currentTolerance->setObjectName(QStringLiteral("currentTolerance"));
    auto* toleranceLabel = new QLabel(this);
    toleranceLabel->setBuddy(m_currentTolerance);
    auto* toleranceRow = withUnit(m_currentTolerance, "%", this);
    m_labels.push_back(toleranceLabel);
    m_form->addRow(toleranceLabel, toleranceRow);
    connect(m_currentTolerance, &widgets::OptionalNumberEdit::valueChanged, this, &IdentifyForm::changed);
    m_seed = new QSpinBox(this);
    m_seed->setRange(0, std::numeric_limits<int>::max());
    m_seed->setValue(1);
    m_seed->setAlignment(Qt::AlignRight);
    m_labels.push_back(new QLabel(this));
    m_labels.back()->setBuddy(m_seed);
    m_form->addRow(m_labels.back(), m_seed);
    auto* seedLabel = m_labels.back();
    const auto showAdvanced = [toleranceLabel, toleranceRow, seedLabel, seed = m_seed](bool isShown) {
        for (QWidget* part : {static_cast<QWidget*>(toleranceLabel), toleranceRow,
                              static_cast<QWidget*>(seedLabel), static_cast<QWidget*>(seed)}) {
            part->setVisible(isShown);
        }
    };
    connect(m_advanced, &QToolButton::toggled, this, showAdvanced);
    connect(m_seed, QOverload<int>::of(&QSpinBox::valueChanged), this, &IdentifyForm::onChange);
    showAdvanced(false);
}

void IdentifyForm::refreshWords() {
    const QString names[] = {tr("F&rom current"),
                             tr("T&o current"),
                             tr("Ste&p"),
                             tr("&Directions"),
                             tr("Given inertia &J"),
                             tr("Given dampi&ng c"),
                             tr("Given friction K<sub>f</sub>"),
                             tr("Given torque constant \u03c6"),
                             tr("Current to&lerance"),
                             tr("&Seed")};
    const QString helps[] = {tr("First current of the sweep; well above the breakaway current"),
                             tr("Last current of the sweep"),
                             tr("Increment of the current"),
                             tr("Both directions also show the asymmetry of friction"),
                             tr("Known inertia of all rotating parts, for absolute values. Empty: unknown"),
                             tr("Known viscous damping. Empty: unknown"),
                             tr("Known Coulomb friction. Empty: unknown"),
                             tr("Known torque constant. Empty: unknown"),
                             tr("Limit of the drive's gain error, in per cent of the current. Empty: the "
                                "published drive, 0.15 % at one sigma"),
                             tr("Seed for plateau order and resampling; equal seeds give equal results")};
    const auto fieldOf = [this](std::size_t i) -> QWidget* { return m_labels[i]->buddy(); };
    for (std::size_t i = 0; i < m_labels.size(); ++i) {
        m_labels[i]->setText(names[i]);
        fieldOf(i)->setAccessibleName(plainWords(names[i]));
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
    m_advanced->setToolTip(tr("Show rarely used settings (Alt+A)"));
    m_advanced->setAccessibleName(tr("Advanced settings"));
}

CurrentSweep IdentifyForm::sweep() const {
    return {shown(*m_currents[0]), shown(*m_currents[1]), shown(*m_currents[2])};
}

bool IdentifyForm::isSweepBackwards() const {
    return sweep().to_A < sweep().from_A;
}

/// Each field is good for itself; together they are not, and that shows at the one to be changed.
void IdentifyForm::markSweep() {
    widgets::QuantityEdit& last = *m_currents[1];
    const bool isBad = isSweepBackwards() || !last.problem().isEmpty();
    widgets::setRole(last, isBad ? widgets::Role::Bad : widgets::Role::None);
}

QStringList IdentifyForm::problems() const {
    QStringList all;
    const auto add = [&all](const QString& name, const QString& problem, const QString& remedy) {
        all << tr("%1: %2").arg(name, problem) + QStringLiteral(" \u2192 ") + remedy;
    };
    for (const widgets::QuantityEdit* box : m_currents) {
        if (const QString problem = problemNow(*box); !problem.isEmpty()) {
            add(box->accessibleName(), problem, tr("Correct the number"));
        }
    }
    if (all.isEmpty() && isSweepBackwards()) {
        add(m_currents[1]->accessibleName(), tr("Smaller than \"%1\".").arg(m_currents[0]->accessibleName()),
            tr("Increase this value or reduce the other"));
    }
    const auto addEdit = [&add](const widgets::OptionalNumberEdit& edit) {
        if (!edit.isValid()) {
            add(edit.accessibleName(), edit.problem(), tr("Correct it or leave it empty"));
        }
    };
    for (const widgets::OptionalNumberEdit* edit : m_given) {
        addEdit(*edit);
    }
    addEdit(*m_currentTolerance);
    return all;
}

Result<IdentifyConfig> IdentifyForm::config() const {
    if (const QStringList all = problems(); !all.isEmpty()) {
        return failure(ErrorCode::InvalidInput, all.join(QLatin1Char('\n')).toStdString());
    }
    if (m_isReverting) {
        return failure(ErrorCode::InvalidInput, m_notice.toStdString());
    }
    IdentifyConfig config;
    config.sweep = sweep();
    config.directions = static_cast<SweepDirections>(m_directions->currentIndex());
    config.seed = static_cast<std::uint64_t>(m_seed->value());
    for (std::size_t i = 0; i < m_given.size(); ++i) {
        if (const std::optional<double> value = m_given[i]->value()) {
            if (auto set = setGivenConstant(config.given, GivenAll[i].symbol, *value); !set) {
                return failure(set.error());
            }
        }
    }
    if (const std::optional<double> tolerance_percent = m_currentTolerance->value()) {
        if (auto set = setCurrentTolerance(config, *tolerance_percent); !set) {
            return failure(set.error());
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
    markSweep();
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
