#pragma once

#include <QWidget>

#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace halbench::widgets {

/// A long action: what it does, how far it is, the time left, Cancel, which has its focus.
class ProgressRow : public QWidget {
    Q_OBJECT
public:
    explicit ProgressRow(QWidget* parent = nullptr);

    void setText(const QString& text);
    /// No fraction: how far it is is not known. No time: neither is the time left.
    void setProgress(std::optional<double> fraction, std::optional<double> remaining_s = std::nullopt);
    /// After Cancel: says so and waits; `setProgress` makes it usable again.
    void setCancelling();

Q_SIGNALS:
    void cancelRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void refreshWords();

    QLabel* m_text = nullptr;
    QProgressBar* m_bar = nullptr;
    QLabel* m_share = nullptr;
    QLabel* m_remaining = nullptr;
    QPushButton* m_cancel = nullptr;
    std::optional<double> m_remaining_s;
    bool m_isCancelling = false;
};

/// "0:07", "12:34", "1:02:03"
QString durationText(double duration_s);

} // namespace halbench::widgets
