<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Panels</name>
    <message>
        <source>Monitor</source>
        <translation>监视</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>辨识</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Field &amp;&amp; Pose</source>
        <translation>磁场与位姿</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>磁场</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibratePanel</name>
    <message>
        <source>Save calibration</source>
        <translation>保存标定</translation>
    </message>
    <message>
        <source>Calibration (*.json)</source>
        <translation>标定 (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Propose</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Finds what the angle sensors and the coils do to the measured angle, and how much current the rotor needs to start.</source>
        <translation>确定角度传感器和线圈对测得角度的影响，以及转子起动所需的电流。</translation>
    </message>
    <message>
        <source>&amp;Hall sensors</source>
        <translation>霍尔传感器(&amp;H)</translation>
    </message>
    <message>
        <source>Two offsets, gain, right angle and amplitude from the ellipse of the readings</source>
        <translation>由读数椭圆得到两个偏置、增益、正交角和幅值</translation>
    </message>
    <message>
        <source>&amp;Stray field of the coils</source>
        <translation>线圈的杂散磁场(&amp;S)</translation>
    </message>
    <message>
        <source>Without it the recommended gains are unstable</source>
        <translation>缺少它，推荐的增益会不稳定</translation>
    </message>
    <message>
        <source>Static &amp;friction</source>
        <translation>静摩擦(&amp;F)</translation>
    </message>
    <message>
        <source>A figure only: it changes no parameter</source>
        <translation>仅为一个数值：不改变任何参数</translation>
    </message>
    <message>
        <source>Start calibration</source>
        <translation>开始标定</translation>
    </message>
    <message>
        <source>The rotor moves; Esc stops it</source>
        <translation>转子会运动；按 Esc 键停止</translation>
    </message>
    <message>
        <source>Write the proposed values in one transaction and read them back</source>
        <translation>以一次事务写入建议值并回读</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Write the values from before the calibration</source>
        <translation>写回标定之前的值</translation>
    </message>
    <message>
        <source>Save calibration…</source>
        <translation>保存标定…</translation>
    </message>
    <message>
        <source>Write the result as a file</source>
        <translation>将结果写成文件</translation>
    </message>
    <message>
        <source>Calibrate again</source>
        <translation>重新标定</translation>
    </message>
    <message>
        <source>Back to the choice</source>
        <translation>返回选择</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Calibrating</source>
        <translation>正在标定</translation>
    </message>
    <message>
        <source>The calibration was cancelled; everything is as it was before.</source>
        <translation>标定已取消；一切恢复原状。</translation>
    </message>
    <message>
        <source>Calibrated values</source>
        <translation>标定值</translation>
    </message>
    <message>
        <source>Applied and read back; it stays until the device is switched off.</source>
        <translation>已应用并回读；在设备断电之前有效。</translation>
    </message>
    <message>
        <source>The values from before are back.</source>
        <translation>之前的值已恢复。</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibrateWords</name>
    <message>
        <source>offset of Hall sensor A</source>
        <translation>霍尔传感器 A 的偏置</translation>
    </message>
    <message>
        <source>offset of Hall sensor B</source>
        <translation>霍尔传感器 B 的偏置</translation>
    </message>
    <message>
        <source>gain of B over A</source>
        <translation>B 相对 A 的增益</translation>
    </message>
    <message>
        <source>error of the right angle</source>
        <translation>正交角误差</translation>
    </message>
    <message>
        <source>amplitude of the field</source>
        <translation>磁场幅值</translation>
    </message>
    <message>
        <source>stray field of the coils</source>
        <translation>线圈的杂散磁场</translation>
    </message>
    <message>
        <source>breakaway current, static</source>
        <translation>静态起动电流</translation>
    </message>
    <message>
        <source>Hall: the rotor turns slowly both ways at %1.</source>
        <translation>霍尔：转子以 %1 双向缓慢转动。</translation>
    </message>
    <message>
        <source>Stray field: the rotor is held at three angles, without torque, at up to %1.</source>
        <translation>杂散磁场：转子在三个角度处以最大 %1 保持，无转矩。</translation>
    </message>
    <message>
        <source>Static friction: the current rises to at most %1 until the rotor starts, %2 times each way.</source>
        <translation>静摩擦：电流升至最多 %1 直到转子起动，每个方向 %2 次。</translation>
    </message>
    <message>
        <source>Choose at least one calibration.</source>
        <translation>请至少选择一项标定。</translation>
    </message>
    <message>
        <source>The board ends the motion at %1 rad/s. Nothing is changed until you apply it.</source>
        <translation>转速达到 %1 rad/s 时控制板结束运动。应用之前不会更改任何内容。</translation>
    </message>
    <message>
        <source>a figure only</source>
        <translation>仅为数值</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>当前 %1</translation>
    </message>
    <message>
        <source>Angle error (rms): %1 with the present values, %2 with the proposed ones.</source>
        <translation>角度误差（有效值）：现有值为 %1，建议值为 %2。</translation>
    </message>
</context>
<context>
    <name>halbench::app::CalibrationFigures</name>
    <message>
        <source>current at the first motion</source>
        <translation>开始运动时的电流</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>正向</translation>
    </message>
    <message>
        <source>reverse, sign removed</source>
        <translation>反向，去掉符号</translation>
    </message>
    <message>
        <source>Static friction over the angle</source>
        <translation>静摩擦与角度的关系</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
</context>
<context>
    <name>halbench::app::DevicePanel</name>
    <message>
        <source>Devices that can be connected</source>
        <translation>可以连接的设备</translation>
    </message>
    <message>
        <source>Enter or double click connects</source>
        <translation>按回车键或双击即可连接</translation>
    </message>
    <message>
        <source>Device address</source>
        <translation>设备地址</translation>
    </message>
    <message>
        <source>For example sim:htm?seed=7 or tcp:HOST:PORT</source>
        <translation>例如 sim:htm?seed=7 或 tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>sim:htm or tcp:HOST:PORT</source>
        <translation>sim:htm 或 tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>Simulated &amp;time</source>
        <translation>仿真时间(&amp;T)</translation>
    </message>
    <message>
        <source>Speed of simulated time</source>
        <translation>仿真时间的快慢</translation>
    </message>
    <message>
        <source>How fast the simulated motor lives; a real device has its own time</source>
        <translation>仿真电机运行的快慢；真实设备有自己的时间</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>5 times</source>
        <translation>5 倍</translation>
    </message>
    <message>
        <source>20 times</source>
        <translation>20 倍</translation>
    </message>
    <message>
        <source>100 times</source>
        <translation>100 倍</translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation>尽可能快</translation>
    </message>
    <message>
        <source>Identity of the device</source>
        <translation>设备标识</translation>
    </message>
    <message>
        <source>Model, identity and firmware as the device says</source>
        <translation>设备报告的型号、标识和固件</translation>
    </message>
    <message>
        <source>No device is named.</source>
        <translation>没有指定设备。</translation>
    </message>
    <message>
        <source>Choose one from the list or write its address.</source>
        <translation>请从列表中选择，或输入设备地址。</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>连接(&amp;C)</translation>
    </message>
    <message>
        <source>Dis&amp;connect</source>
        <translation>断开(&amp;C)</translation>
    </message>
    <message>
        <source>Connect the device (Alt+C)</source>
        <translation>连接设备 (Alt+C)</translation>
    </message>
    <message>
        <source>End what runs, disarm and disconnect (Alt+C)</source>
        <translation>结束正在运行的任务，解除使能并断开 (Alt+C)</translation>
    </message>
    <message>
        <source>%1
Firmware %2</source>
        <translation>%1
固件 %2</translation>
    </message>
</context>
<context>
    <name>halbench::app::DeviceSession</name>
    <message>
        <source>board</source>
        <translation>控制板</translation>
    </message>
    <message>
        <source>connection</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>connecting %1</source>
        <translation>正在连接 %1</translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation>已断开</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>connected %1, firmware %2</source>
        <translation>已连接 %1，固件 %2</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>the window did not answer while the actuator was armed, so it was stopped</source>
        <translation>执行器处于使能状态时窗口没有响应，因此已将其停止</translation>
    </message>
</context>
<context>
    <name>halbench::app::DisplayQuantity</name>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>r/min</source>
        <translation>r/min</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>field</source>
        <translation>磁场</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>current slope</source>
        <translation>电流变化率</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考值</translation>
    </message>
    <message>
        <source>Current command</source>
        <translation>电流指令</translation>
    </message>
    <message>
        <source>Current A</source>
        <translation>电流 A</translation>
    </message>
    <message>
        <source>Current B</source>
        <translation>电流 B</translation>
    </message>
    <message>
        <source>Hall A</source>
        <translation>霍尔 A</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>霍尔 B</translation>
    </message>
    <message>
        <source>Coil A</source>
        <translation>线圈 A</translation>
    </message>
    <message>
        <source>Coil B</source>
        <translation>线圈 B</translation>
    </message>
    <message>
        <source>Board state</source>
        <translation>控制板状态</translation>
    </message>
    <message>
        <source>Fault code</source>
        <translation>故障代码</translation>
    </message>
    <message>
        <source>Torn parameter sets</source>
        <translation>不一致的参数组</translation>
    </message>
    <message>
        <source>Generator segment</source>
        <translation>发生器段号</translation>
    </message>
    <message>
        <source>Generator running</source>
        <translation>发生器运行中</translation>
    </message>
    <message>
        <source>Capture state</source>
        <translation>捕获状态</translation>
    </message>
    <message>
        <source>Capture time</source>
        <translation>捕获时间</translation>
    </message>
    <message>
        <source>True angle</source>
        <translation>真实角度</translation>
    </message>
    <message>
        <source>True speed</source>
        <translation>真实转速</translation>
    </message>
</context>
<context>
    <name>halbench::app::DriveLimits</name>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>A larger current is not commanded; asking for one in a current mode stops</source>
        <translation>不会输出更大的电流；在电流模式下要求更大电流会触发停止</translation>
    </message>
    <message>
        <source>Hotter coil</source>
        <translation>较热的线圈</translation>
    </message>
    <message>
        <source>The board stops when a coil is hotter</source>
        <translation>任一线圈超过此温度时控制板停止</translation>
    </message>
    <message>
        <source>Excursion</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>The board stops when it is farther from where it was armed</source>
        <translation>转子离使能时的位置超过此值时控制板停止</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>The board stops when it turns faster</source>
        <translation>转速超过此值时控制板停止</translation>
    </message>
    <message>
        <source>Off: not watched (Space)</source>
        <translation>关：不监视（空格键）</translation>
    </message>
    <message>
        <source>%1 now</source>
        <translation>当前 %1</translation>
    </message>
    <message>
        <source>Limit of %1</source>
        <translation>%1的限值</translation>
    </message>
    <message>
        <source>Enter writes it</source>
        <translation>按回车键写入</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a limit, nothing was written.</source>
        <translation>“%1”不是限值，未写入任何内容。</translation>
    </message>
    <message>
        <source>Allowed: %1.</source>
        <translation>允许：%1。</translation>
    </message>
</context>
<context>
    <name>halbench::app::DrivePanel</name>
    <message>
        <source>What the board says of itself</source>
        <translation>控制板报告的自身状态</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>模式(&amp;M)</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>D-axis</source>
        <translation>D 轴</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Idle: no current. Current: torque by hand. Position: holds and follows.
D-axis: current that holds the rotor without turning it (Alt+M)</source>
        <translation>空闲：无电流。电流：手动给定转矩。位置：保持并跟随。
D 轴：保持转子而不使其转动的电流 (Alt+M)</translation>
    </message>
    <message>
        <source>Set-point and jog</source>
        <translation>设定值与点动</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>执行</translation>
    </message>
    <message>
        <source>Sends the set-point (Enter in the field)</source>
        <translation>发送设定值（在输入框中按回车键）</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>归零</translation>
    </message>
    <message>
        <source>Sends the set-point zero</source>
        <translation>发送零设定值</translation>
    </message>
    <message>
        <source>Reference generator</source>
        <translation>参考信号发生器</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Starts the reference from where the rotor is (Ctrl+Shift+R)</source>
        <translation>从转子当前位置启动参考信号 (Ctrl+Shift+R)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Ends the reference: a position is held, a current goes to zero (Ctrl+Shift+E)</source>
        <translation>结束参考信号：位置保持，电流归零 (Ctrl+Shift+E)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Limits of the board</source>
        <translation>控制板限值</translation>
    </message>
    <message>
        <source>Armed, the actuator can move at any moment.</source>
        <translation>使能后，执行器随时可能运动。</translation>
    </message>
    <message>
        <source>Keep hands, hair, cables and loose parts away from it. Esc stops it.</source>
        <translation>请让手、头发、线缆和松动的物件远离它。按 Esc 键停止。</translation>
    </message>
    <message>
        <source>Arm it</source>
        <translation>确认使能</translation>
    </message>
    <message>
        <source>Now %1</source>
        <translation>当前 %1</translation>
    </message>
    <message>
        <source>Arm first; set-points start at zero.</source>
        <translation>请先使能；设定值从零开始。</translation>
    </message>
    <message>
        <source>Release the stop</source>
        <translation>解除停止</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>无设备</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>%1 is running</source>
        <translation>%1正在运行</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>Disarmed</source>
        <translation>未使能</translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation>状态：%1</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>解除使能</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>No current; set-points to zero (Ctrl+Shift+A)</source>
        <translation>无电流；设定值归零 (Ctrl+Shift+A)</translation>
    </message>
    <message>
        <source>Lets the actuator move; set-points start at zero (Ctrl+Shift+A)</source>
        <translation>允许执行器运动；设定值从零开始 (Ctrl+Shift+A)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>Angle from where it was armed (Enter sends it)</source>
        <translation>相对使能位置的角度（按回车键发送）</translation>
    </message>
    <message>
        <source>Current (Enter sends it)</source>
        <translation>电流（按回车键发送）</translation>
    </message>
    <message>
        <source>Moves up to %1 from where it is.</source>
        <translation>从当前位置最多运动 %1。</translation>
    </message>
    <message>
        <source>Commands up to %1.</source>
        <translation>最多输出 %1。</translation>
    </message>
    <message>
        <source>That is beyond the limit: the board may stop it.</source>
        <translation>超出限值：控制板可能会停止。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a set-point, nothing was sent.</source>
        <translation>“%1”不是设定值，未发送任何内容。</translation>
    </message>
    <message>
        <source>Allowed: %1.</source>
        <translation>允许：%1。</translation>
    </message>
</context>
<context>
    <name>halbench::app::FaultWords</name>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Nothing moves until the stop is released and the device armed again.</source>
        <translation>在解除停止并重新使能之前，不会有任何运动。</translation>
    </message>
    <message>
        <source>A coil is hotter than its limit</source>
        <translation>线圈温度超过限值</translation>
    </message>
    <message>
        <source>Let the coils cool down; drive with less current or with pauses.</source>
        <translation>请让线圈冷却；减小电流或间歇运行。</translation>
    </message>
    <message>
        <source>More current was asked for than the limit allows</source>
        <translation>要求的电流超过限值</translation>
    </message>
    <message>
        <source>Use a smaller set-point or amplitude.</source>
        <translation>请减小设定值或幅值。</translation>
    </message>
    <message>
        <source>It turned faster than its window allows</source>
        <translation>转速超出允许范围</translation>
    </message>
    <message>
        <source>Use less current or a slower reference, or widen the speed window on purpose.</source>
        <translation>请减小电流或放慢参考信号，或有意识地放宽转速范围。</translation>
    </message>
    <message>
        <source>It moved farther than its window allows</source>
        <translation>位移超出允许范围</translation>
    </message>
    <message>
        <source>Use a smaller motion, or widen the excursion window on purpose.</source>
        <translation>请减小运动幅度，或有意识地放宽偏移范围。</translation>
    </message>
    <message>
        <source>The measured angle jumped</source>
        <translation>测得的角度发生跳变</translation>
    </message>
    <message>
        <source>Turn more slowly; look for magnets or iron near the Hall sensors.</source>
        <translation>请放慢转动；检查霍尔传感器附近是否有磁体或铁件。</translation>
    </message>
    <message>
        <source>A Hall sensor does not see the rotor</source>
        <translation>某个霍尔传感器检测不到转子</translation>
    </message>
    <message>
        <source>Look at sensors and plug, and calibrate the Hall sensors.</source>
        <translation>请检查传感器和插头，并标定霍尔传感器。</translation>
    </message>
    <message>
        <source>The controller computed a number that is none</source>
        <translation>控制器算出了非数值</translation>
    </message>
    <message>
        <source>Write gains that are known to work.</source>
        <translation>请写入已知可用的增益。</translation>
    </message>
</context>
<context>
    <name>halbench::app::FieldPanel</name>
    <message>
        <source>&amp;Ideal</source>
        <translation>理想(&amp;I)</translation>
    </message>
    <message>
        <source>Field of an ideal Halbach cylinder (Alt+I)</source>
        <translation>理想海尔贝克圆筒的磁场 (Alt+I)</translation>
    </message>
    <message>
        <source>Se&amp;gmented</source>
        <translation>分段(&amp;G)</translation>
    </message>
    <message>
        <source>Field of its separate magnets (Alt+G)</source>
        <translation>各独立磁体的磁场 (Alt+G)</translation>
    </message>
    <message>
        <source>Meas&amp;ured</source>
        <translation>实测(&amp;U)</translation>
    </message>
    <message>
        <source>Direction and size that the Hall sensors see (Alt+U)</source>
        <translation>霍尔传感器测得的方向和大小 (Alt+U)</translation>
    </message>
    <message>
        <source>Shows the rotor of a connected motor with Hall sensors.</source>
        <translation>显示已连接的带霍尔传感器电机的转子。</translation>
    </message>
</context>
<context>
    <name>halbench::app::GainEditor</name>
    <message>
        <source>a number is missing</source>
        <translation>缺少数值</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Write a number of zero or more</source>
        <translation>请输入不小于零的数</translation>
    </message>
    <message>
        <source>Proportional K_P</source>
        <translation>比例 K_P</translation>
    </message>
    <message>
        <source>Integral K_I</source>
        <translation>积分 K_I</translation>
    </message>
    <message>
        <source>Derivative K_D</source>
        <translation>微分 K_D</translation>
    </message>
    <message>
        <source>Feed-forward of inertia</source>
        <translation>惯量前馈</translation>
    </message>
    <message>
        <source>Feed-forward of damping</source>
        <translation>阻尼前馈</translation>
    </message>
    <message>
        <source>Feed-forward of friction</source>
        <translation>摩擦前馈</translation>
    </message>
    <message>
        <source>... in full from speed</source>
        <translation>... 全部作用的起始转速</translation>
    </message>
    <message>
        <source>Friction assist</source>
        <translation>摩擦补偿</translation>
    </message>
    <message>
        <source>... from an error of</source>
        <translation>... 起始误差</translation>
    </message>
    <message>
        <source>... below a reference speed of</source>
        <translation>... 参考转速低于</translation>
    </message>
    <message>
        <source>%1 of the board</source>
        <translation>控制板的 %1</translation>
    </message>
    <message>
        <source>Parallel form, per</source>
        <translation>并联形式，单位</translation>
    </message>
    <message>
        <source>Unit of the gains</source>
        <translation>增益的单位</translation>
    </message>
    <message>
        <source>A/rad and A/° differ by 57.3; files and the board use A/rad</source>
        <translation>A/rad 与 A/° 相差 57.3 倍；文件和控制板使用 A/rad</translation>
    </message>
    <message>
        <source>Feed-forward and friction assist</source>
        <translation>前馈与摩擦补偿</translation>
    </message>
    <message>
        <source>Show the gains that act on the reference</source>
        <translation>显示作用于参考值的增益</translation>
    </message>
</context>
<context>
    <name>halbench::app::HelpWindow</name>
    <message>
        <source>Halbench help</source>
        <translation>Halbench 帮助</translation>
    </message>
    <message>
        <source>Help page</source>
        <translation>帮助页面</translation>
    </message>
    <message>
        <source>Alt+Left goes back</source>
        <translation>Alt+向左键返回</translation>
    </message>
    <message>
        <source>There is no help page &apos;%1&apos; in this program.</source>
        <translation>本程序中没有帮助页面“%1”。</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>The page before (Alt+Left)</source>
        <translation>上一页 (Alt+Left)</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentificationFigures</name>
    <message>
        <source>fit forward</source>
        <translation>正向拟合</translation>
    </message>
    <message>
        <source>fit reverse</source>
        <translation>反向拟合</translation>
    </message>
    <message>
        <source>Joint 95 % region of damping and friction</source>
        <translation>阻尼与摩擦的 95 % 联合区域</translation>
    </message>
    <message>
        <source>95 % joint region</source>
        <translation>95 % 联合置信域</translation>
    </message>
    <message>
        <source>Steady speed against current amplitude</source>
        <translation>稳态转速与电流幅值</translation>
    </message>
    <message>
        <source>current amplitude</source>
        <translation>电流幅值</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>viscous damping c</source>
        <translation>粘性阻尼 c</translation>
    </message>
    <message>
        <source>Coulomb friction K_f</source>
        <translation>库仑摩擦 K_f</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyForm</name>
    <message>
        <source>&amp;From current</source>
        <translation>起始电流(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;To current</source>
        <translation>终止电流(&amp;T)</translation>
    </message>
    <message>
        <source>Ste&amp;p</source>
        <translation>步长(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Directions</source>
        <translation>方向(&amp;D)</translation>
    </message>
    <message>
        <source>Given inertia &amp;J</source>
        <translation>已知惯量 &amp;J</translation>
    </message>
    <message>
        <source>Given damping &amp;c</source>
        <translation>已知阻尼 &amp;c</translation>
    </message>
    <message>
        <source>Given friction &amp;K_f</source>
        <translation>已知摩擦 &amp;K_f</translation>
    </message>
    <message>
        <source>Given torque constant φ</source>
        <translation>已知转矩常数 φ</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>随机种子(&amp;S)</translation>
    </message>
    <message>
        <source>First steady current of the sweep; well above the breakaway current</source>
        <translation>扫描的第一个稳态电流；应明显高于起动电流</translation>
    </message>
    <message>
        <source>Last steady current of the sweep, included</source>
        <translation>扫描的最后一个稳态电流（含）</translation>
    </message>
    <message>
        <source>Distance of the currents</source>
        <translation>电流间隔</translation>
    </message>
    <message>
        <source>Both ways also tell how friction differs between them</source>
        <translation>双向测量还能看出两个方向的摩擦差异</translation>
    </message>
    <message>
        <source>Known inertia of all that turns; makes absolute values of ratios. Empty: not known</source>
        <translation>所有转动部分的已知转动惯量；使比值变为绝对值。留空：未知</translation>
    </message>
    <message>
        <source>Known viscous damping. Empty: not known</source>
        <translation>已知粘性阻尼。留空：未知</translation>
    </message>
    <message>
        <source>Known Coulomb friction. Empty: not known</source>
        <translation>已知库仑摩擦。留空：未知</translation>
    </message>
    <message>
        <source>Known torque constant. Empty: not known</source>
        <translation>已知转矩常数。留空：未知</translation>
    </message>
    <message>
        <source>Order of the plateaus and resampling; equal seeds give equal results</source>
        <translation>平台顺序和重采样；相同的种子给出相同的结果</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>未给定</translation>
    </message>
    <message>
        <source>both</source>
        <translation>双向</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>正向</translation>
    </message>
    <message>
        <source>reverse</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>&amp;Advanced</source>
        <translation>高级(&amp;A)</translation>
    </message>
    <message>
        <source>Show what is seldom changed (Alt+A)</source>
        <translation>显示不常更改的设置 (Alt+A)</translation>
    </message>
    <message>
        <source>Advanced settings</source>
        <translation>高级设置</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>请更正或留空</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyPanel</name>
    <message>
        <source>Save as model</source>
        <translation>另存为模型</translation>
    </message>
    <message>
        <source>Model (*.json)</source>
        <translation>模型 (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Excite</source>
        <translation>激励</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应</translation>
    </message>
    <message>
        <source>Judge</source>
        <translation>评判</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Finds damping, friction, torque constant and inertia of the motor with their 95 % intervals, by turning it at steady currents and letting it coast.</source>
        <translation>以恒定电流转动电机并令其自由减速，从而求得阻尼、摩擦、转矩常数和转动惯量及其 95 % 区间。</translation>
    </message>
    <message>
        <source>Start identification</source>
        <translation>开始辨识</translation>
    </message>
    <message>
        <source>The rotor turns (Ctrl+Return); Esc stops it</source>
        <translation>转子会转动 (Ctrl+Return)；按 Esc 键停止</translation>
    </message>
    <message>
        <source>Load model…</source>
        <translation>载入模型…</translation>
    </message>
    <message>
        <source>Show a model that was saved before</source>
        <translation>显示以前保存的模型</translation>
    </message>
    <message>
        <source>Tune with this</source>
        <translation>用它整定</translation>
    </message>
    <message>
        <source>Go on to the gains for this motor</source>
        <translation>继续为此电机设计增益</translation>
    </message>
    <message>
        <source>Save as model…</source>
        <translation>另存为模型…</translation>
    </message>
    <message>
        <source>Write the file that the program&apos;s tune and analyse read</source>
        <translation>写出供本程序 tune 和 analyse 读取的文件</translation>
    </message>
    <message>
        <source>Identify again</source>
        <translation>重新辨识</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next one</source>
        <translation>返回设置；此结果保留到下一次</translation>
    </message>
    <message>
        <source>Plateaus as they are completed; the fit comes afterwards</source>
        <translation>已完成的平台；随后进行拟合</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>辨识</translation>
    </message>
    <message>
        <source>Identifying</source>
        <translation>正在辨识</translation>
    </message>
    <message>
        <source>The rotor turns: plateaus and coast-downs</source>
        <translation>转子转动：平台与自由减速</translation>
    </message>
    <message>
        <source>Fitting all of the motion</source>
        <translation>正在拟合全部运动</translation>
    </message>
    <message>
        <source>The identification was cancelled; everything is as it was before.</source>
        <translation>辨识已取消；一切恢复原状。</translation>
    </message>
    <message>
        <source>Load model</source>
        <translation>载入模型</translation>
    </message>
    <message>
        <source>Identify again when the motor has changed since.</source>
        <translation>如果电机此后有变化，请重新辨识。</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyResultView</name>
    <message>
        <source>Identified values</source>
        <translation>辨识值</translation>
    </message>
    <message>
        <source>Fit and residuals</source>
        <translation>拟合与残差</translation>
    </message>
    <message>
        <source>Joint region</source>
        <translation>联合区域</translation>
    </message>
    <message>
        <source>Steady speed against current, and what the fit leaves over</source>
        <translation>稳态转速与电流，以及拟合的残余</translation>
    </message>
    <message>
        <source>Where damping and friction lie together with 95 % probability</source>
        <translation>阻尼和摩擦以 95 % 概率共同所在的区域</translation>
    </message>
    <message>
        <source>Pictures of the identification</source>
        <translation>辨识图</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Picture (*.svg *.png)</source>
        <translation>图片 (*.svg *.png)</translation>
    </message>
</context>
<context>
    <name>halbench::app::IdentifyWords</name>
    <message>
        <source>identified</source>
        <translation>辨识得到</translation>
    </message>
    <message>
        <source>given</source>
        <translation>给定</translation>
    </message>
    <message>
        <source>not identifiable</source>
        <translation>不可辨识</translation>
    </message>
    <message>
        <source>Angle and current alone show only quotients; see below what would supply it</source>
        <translation>仅凭角度和电流只能得到比值；所缺条件见下文</translation>
    </message>
    <message>
        <source>K_f/φ, breakaway current</source>
        <translation>K_f/φ，起动电流</translation>
    </message>
    <message>
        <source>both ways</source>
        <translation>双向</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>正向</translation>
    </message>
    <message>
        <source>in reverse</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>The rotor will turn %1, about %2 turns in all, at up to %3 rad/s (%4 r/min), for %5 minutes of device time.</source>
        <translation>转子将%1转动，共约 %2 圈，最高 %3 rad/s（%4 r/min），历时 %5 分钟设备时间。</translation>
    </message>
    <message>
        <source>Current up to %1 A, coils up to %2 °C.</source>
        <translation>电流最大 %1 A，线圈最高 %2 °C。</translation>
    </message>
    <message>
        <source>Current up to %1 A; it waits for the coils to cool where they would come near %2 °C.</source>
        <translation>电流最大 %1 A；线圈将接近 %2 °C 时等待冷却。</translation>
    </message>
    <message>
        <source>The board ends the motion at %1 rad/s; gains and limits are restored whatever happens.</source>
        <translation>转速达到 %1 rad/s 时控制板结束运动；无论如何都会恢复增益和限值。</translation>
    </message>
    <message>
        <source>viscous damping c</source>
        <translation>粘性阻尼 c</translation>
    </message>
    <message>
        <source>Coulomb friction K_f</source>
        <translation>库仑摩擦 K_f</translation>
    </message>
    <message>
        <source>torque constant φ</source>
        <translation>转矩常数 φ</translation>
    </message>
    <message>
        <source>inertia J</source>
        <translation>转动惯量 J</translation>
    </message>
    <message>
        <source>asymmetry of the friction</source>
        <translation>摩擦的不对称性</translation>
    </message>
    <message>
        <source>Good: nothing speaks against the model</source>
        <translation>良好：没有与模型相悖之处</translation>
    </message>
    <message>
        <source>Doubtful: look at the findings before you rely on it</source>
        <translation>存疑：采信之前请查看诊断</translation>
    </message>
    <message>
        <source>Refused: there is no result to rely on</source>
        <translation>拒绝：没有可信的结果</translation>
    </message>
    <message>
        <source>Not identifiable: %1. Angle and current show quotients only; one of these supplies the scale:</source>
        <translation>不可辨识：%1。角度和电流只能给出比值；以下任一项可提供尺度：</translation>
    </message>
    <message>
        <source>• the inertia J of all that turns (drawing, or weighed): c, K_f and φ follow</source>
        <translation>• 所有转动部分的转动惯量 J（图纸或称重）：可得 c、K_f 和 φ</translation>
    </message>
    <message>
        <source>• the torque constant φ (data sheet): J, c and K_f follow</source>
        <translation>• 转矩常数 φ（数据手册）：可得 J、c 和 K_f</translation>
    </message>
    <message>
        <source>• no data at all: fix a part of known inertia to the rotor and identify again</source>
        <translation>• 没有任何数据：在转子上固定一个惯量已知的部件，再次辨识</translation>
    </message>
    <message>
        <source>• the torque constant φ (data sheet): c and K_f follow, J does not</source>
        <translation>• 转矩常数 φ（数据手册）：可得 c 和 K_f，但得不到 J</translation>
    </message>
    <message>
        <source>• run-ups and coast-downs besides the steady plateaus: then J or φ is enough</source>
        <translation>• 除稳态平台外再加升速和自由减速：则 J 或 φ 即可</translation>
    </message>
    <message>
        <source>Tuning works without: it needs the quotients alone.</source>
        <translation>整定不需要它：只需比值即可。</translation>
    </message>
    <message>
        <source>Device %1, firmware %2</source>
        <translation>设备 %1，固件 %2</translation>
    </message>
    <message>
        <source>overrides %1</source>
        <translation>覆盖项 %1</translation>
    </message>
    <message>
        <source>Device not known</source>
        <translation>设备未知</translation>
    </message>
    <message>
        <source>Halbench %1</source>
        <translation>Halbench %1</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>种子 %1</translation>
    </message>
    <message>
        <source>started %1</source>
        <translation>开始于 %1</translation>
    </message>
    <message>
        <source>%1 minutes of device time, coils up to %2 °C</source>
        <translation>%1 分钟设备时间，线圈最高 %2 °C</translation>
    </message>
    <message>
        <source>device not known</source>
        <translation>设备未知</translation>
    </message>
    <message>
        <source>From the project: identified in virtual time, device %1.</source>
        <translation>来自项目：在虚拟时间内辨识，设备 %1。</translation>
    </message>
    <message>
        <source>From the project: identified %1, device %2.</source>
        <translation>来自项目：辨识时间 %1，设备 %2。</translation>
    </message>
</context>
<context>
    <name>halbench::app::JogRow</name>
    <message>
        <source>− Back</source>
        <translation>− 后退</translation>
    </message>
    <message>
        <source>Moves backward while it is held (hold Space)</source>
        <translation>按住时向后运动（按住空格键）</translation>
    </message>
    <message>
        <source>Forward +</source>
        <translation>前进 +</translation>
    </message>
    <message>
        <source>Moves forward while it is held (hold Space)</source>
        <translation>按住时向前运动（按住空格键）</translation>
    </message>
    <message>
        <source>Jog speed</source>
        <translation>点动转速</translation>
    </message>
    <message>
        <source>How fast it moves while a button is held</source>
        <translation>按住按钮时的运动速度</translation>
    </message>
    <message>
        <source>Jog current</source>
        <translation>点动电流</translation>
    </message>
    <message>
        <source>The current while a button is held</source>
        <translation>按住按钮时的电流</translation>
    </message>
</context>
<context>
    <name>halbench::app::LinkPanel</name>
    <message>
        <source>Link statistics</source>
        <translation>链路统计</translation>
    </message>
    <message>
        <source>Packets per second of device time, packets lost and damaged, median and worst answer time</source>
        <translation>每秒（设备时间）数据包数、丢失和损坏的数据包、响应时间的中位数和最大值</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>控制板</translation>
    </message>
    <message>
        <source>Firmware of the board and its state in words</source>
        <translation>控制板固件及其状态说明</translation>
    </message>
    <message>
        <source>link: connecting</source>
        <translation>链路：正在连接</translation>
    </message>
    <message>
        <source>link: none</source>
        <translation>链路：无</translation>
    </message>
    <message>
        <source>link: %1 packets/s, %2 lost, %3 damaged, %4 ms (worst %5 ms)</source>
        <translation>链路：%1 包/秒，丢失 %2，损坏 %3，%4 ms（最长 %5 ms）</translation>
    </message>
    <message>
        <source>board: firmware %1%2</source>
        <translation>控制板：固件 %1%2</translation>
    </message>
    <message>
        <source>, %1</source>
        <translation>，%1</translation>
    </message>
</context>
<context>
    <name>halbench::app::LivePlateaus</name>
    <message>
        <source>line forward</source>
        <translation>正向直线</translation>
    </message>
    <message>
        <source>line reverse</source>
        <translation>反向直线</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>plateaus so far</source>
        <translation>已完成的平台</translation>
    </message>
    <message>
        <source>Steady speed against current amplitude</source>
        <translation>稳态转速与电流幅值</translation>
    </message>
    <message>
        <source>current amplitude</source>
        <translation>电流幅值</translation>
    </message>
</context>
<context>
    <name>halbench::app::MainWindow</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>Connect the s&amp;imulated motor</source>
        <translation>连接仿真电机(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Reset the arrangement</source>
        <translation>重置布局(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主题(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>语言(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Help on this panel</source>
        <translation>此面板的帮助(&amp;H)</translation>
    </message>
    <message>
        <source>The language changes at the next start.</source>
        <translation>语言将在下次启动时更改。</translation>
    </message>
    <message>
        <source>The project of the last session, which has no name yet, is open again.</source>
        <translation>上次会话中尚未命名的项目已重新打开。</translation>
    </message>
    <message>
        <source>Save it under a name to keep it.</source>
        <translation>请命名保存以保留它。</translation>
    </message>
    <message>
        <source>unnamed project</source>
        <translation>未命名项目</translation>
    </message>
    <message>
        <source>%1[*] — Halbench</source>
        <translation>%1[*] — Halbench</translation>
    </message>
    <message>
        <source>Not everything of the project could be read: %1</source>
        <translation>项目中有内容无法读取：%1</translation>
    </message>
    <message>
        <source>It stays in the file as it is; the rest is open.</source>
        <translation>它在文件中保持原样；其余内容已打开。</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorPanel</name>
    <message>
        <source>Plots</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>More tools</source>
        <translation>更多工具</translation>
    </message>
    <message>
        <source>What the device sends to the plots</source>
        <translation>设备发送到曲线图的内容</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>no signals</source>
        <translation>无信号</translation>
    </message>
    <message>
        <source>time passes only while a procedure runs</source>
        <translation>仅在任务运行时时间才流逝</translation>
    </message>
    <message>
        <source>%1 signals, %2 Hz, %3 rows lost</source>
        <translation>%1 个信号，%2 Hz，丢失 %3 行</translation>
    </message>
</context>
<context>
    <name>halbench::app::NotesPanel</name>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Your notes on this motor; saved with the project</source>
        <translation>您对此电机的备注；随项目保存</translation>
    </message>
    <message>
        <source>Notes on this motor; saved with the project.</source>
        <translation>对此电机的备注；随项目保存。</translation>
    </message>
</context>
<context>
    <name>halbench::app::ParametersPanel</name>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>A named set of parameters, shipped or your own</source>
        <translation>一组命名的参数，自带的或您自己的</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>载入</translation>
    </message>
    <message>
        <source>Edits the rows as the preset says; nothing is written yet</source>
        <translation>按预设编辑各行；尚未写入</translation>
    </message>
    <message>
        <source>Name of the new preset</source>
        <translation>新预设的名称</translation>
    </message>
    <message>
        <source>name of a preset</source>
        <translation>预设名称</translation>
    </message>
    <message>
        <source>Keeps the edited column under this name (Enter)</source>
        <translation>以此名称保存编辑列（回车键）</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Keeps the edited column as a preset (Enter in the name)</source>
        <translation>将编辑列保存为预设（在名称中按回车键）</translation>
    </message>
    <message>
        <source>Save in the device</source>
        <translation>保存到设备</translation>
    </message>
    <message>
        <source>Stores what the device runs with for the next power-up; writing is another act</source>
        <translation>把设备当前运行的值存储供下次上电使用；写入是另一个操作</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) written and read back.</source>
        <translation>
            <numerusform>已写入并回读 %n 个值。</numerusform>
        </translation>
    </message>
    <message>
        <source>They are lost at power-down until they are saved in the device.</source>
        <translation>未保存到设备之前，断电后会丢失。</translation>
    </message>
    <message>
        <source>A simulated device is new every time and has nothing to store in.</source>
        <translation>仿真设备每次都是全新的，无法存储。</translation>
    </message>
    <message>
        <source>Keep the values as a preset, or serve the device to have one that lasts.</source>
        <translation>请将这些值保留为预设，或用 serve 提供设备以便持久保存。</translation>
    </message>
    <message>
        <source>Saved in the device.</source>
        <translation>已保存到设备。</translation>
    </message>
    <message>
        <source>It starts with these values at the next power-up.</source>
        <translation>下次上电时将以这些值启动。</translation>
    </message>
    <message>
        <source>Load %1</source>
        <translation>载入 %1</translation>
    </message>
    <message>
        <source>Not taken from the preset: %1</source>
        <translation>未从预设中采用：%1</translation>
    </message>
    <message>
        <source>This device does not have these parameters, or not with these values.</source>
        <translation>此设备没有这些参数，或不接受这些值。</translation>
    </message>
    <message>
        <source>Kept as %1.</source>
        <translation>已保留为 %1。</translation>
    </message>
</context>
<context>
    <name>halbench::app::Preflight</name>
    <message>
        <source>The rotor may turn now</source>
        <translation>转子现在可以转动</translation>
    </message>
    <message>
        <source>A real motor moves only with your consent</source>
        <translation>真实电机只有经您同意才会运动</translation>
    </message>
    <message>
        <source>Checks before the start</source>
        <translation>启动前检查</translation>
    </message>
</context>
<context>
    <name>halbench::app::PreflightWords</name>
    <message>
        <source>No device is connected</source>
        <translation>没有连接设备</translation>
    </message>
    <message>
        <source>Connect one in the Devices panel</source>
        <translation>请在“设备”面板中连接</translation>
    </message>
    <message>
        <source>Another procedure runs</source>
        <translation>另一个任务正在运行</translation>
    </message>
    <message>
        <source>Wait for its end or cancel it</source>
        <translation>请等待其结束或取消它</translation>
    </message>
    <message>
        <source>The device is connected and free</source>
        <translation>设备已连接且空闲</translation>
    </message>
    <message>
        <source>Fault: %1</source>
        <translation>故障：%1</translation>
    </message>
    <message>
        <source>Remove its cause, then re-arm on purpose in the Drive panel</source>
        <translation>请排除原因，然后在“驱动”面板中有意识地解除</translation>
    </message>
    <message>
        <source>The stop is latched</source>
        <translation>停止处于锁存状态</translation>
    </message>
    <message>
        <source>Release it with the STOP control</source>
        <translation>请用停止按钮解除</translation>
    </message>
    <message>
        <source>The device is armed by hand</source>
        <translation>设备已被手动使能</translation>
    </message>
    <message>
        <source>Disarm it first</source>
        <translation>请先解除使能</translation>
    </message>
    <message>
        <source>No fault, not stopped, not armed</source>
        <translation>无故障，未停止，未使能</translation>
    </message>
    <message>
        <source>Coil temperature not known yet; the procedure measures it first</source>
        <translation>线圈温度未知；任务将首先测量</translation>
    </message>
    <message>
        <source>Coils %1 now</source>
        <translation>线圈当前 %1</translation>
    </message>
    <message>
        <source>%1, at most %2 by forecast</source>
        <translation>%1，预测最高 %2</translation>
    </message>
    <message>
        <source>%1; the run waits where they would come near %2</source>
        <translation>%1；将接近 %2 时运行会等待</translation>
    </message>
    <message>
        <source>Use less current or fewer steps; %1 must not be reached</source>
        <translation>请减小电流或减少步数；不得达到 %1</translation>
    </message>
    <message>
        <source>Simulated: nothing can be hit</source>
        <translation>仿真：不会碰撞任何物体</translation>
    </message>
    <message>
        <source>The rotor is free to turn and nobody touches it</source>
        <translation>转子可自由转动且无人触碰</translation>
    </message>
    <message>
        <source>Look, then say so below</source>
        <translation>请查看，然后在下面确认</translation>
    </message>
</context>
<context>
    <name>halbench::app::ProjectMenu</name>
    <message>
        <source>&amp;New project</source>
        <translation>新建项目(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open project…</source>
        <translation>打开项目(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近的项目(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save project</source>
        <translation>保存项目(&amp;S)</translation>
    </message>
    <message>
        <source>Save project &amp;as…</source>
        <translation>项目另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>打开项目</translation>
    </message>
    <message>
        <source>Halbench project (*.toml)</source>
        <translation>Halbench 项目 (*.toml)</translation>
    </message>
    <message>
        <source>Unsaved work of %1 was recovered; save it to keep it.</source>
        <translation>已恢复 %1 中未保存的工作；请保存以保留。</translation>
    </message>
    <message>
        <source>Save project as</source>
        <translation>项目另存为</translation>
    </message>
    <message>
        <source>No project was opened yet</source>
        <translation>尚未打开过项目</translation>
    </message>
</context>
<context>
    <name>halbench::app::ProjectWork</name>
    <message>
        <source>model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>gains</source>
        <translation>增益</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordPanel</name>
    <message>
        <source>Folder of recordings</source>
        <translation>记录文件夹</translation>
    </message>
    <message>
        <source>Made when it does not exist</source>
        <translation>不存在时自动创建</translation>
    </message>
    <message>
        <source>Name of the recording</source>
        <translation>记录名称</translation>
    </message>
    <message>
        <source>device and date</source>
        <translation>设备和日期</translation>
    </message>
    <message>
        <source>Without ending; empty: device and date</source>
        <translation>不带扩展名；留空：设备和日期</translation>
    </message>
    <message>
        <source>Rows per second</source>
        <translation>每秒行数</translation>
    </message>
    <message>
        <source>At most as many as the device sends</source>
        <translation>最多与设备发送的一样多</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Device time from the first row to the last</source>
        <translation>从第一行到最后一行的设备时间</translation>
    </message>
    <message>
        <source>Rows written</source>
        <translation>已写入行数</translation>
    </message>
    <message>
        <source>On the disk</source>
        <translation>已存盘</translation>
    </message>
    <message>
        <source>Rows missing</source>
        <translation>缺失行数</translation>
    </message>
    <message>
        <source>Lost on the link, or the disk did not keep up; marked in the file</source>
        <translation>链路丢失或磁盘跟不上；已在文件中标明</translation>
    </message>
    <message>
        <source>Note of the marker</source>
        <translation>标记备注</translation>
    </message>
    <message>
        <source>note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>What the marker says (Enter marks)</source>
        <translation>标记的内容（回车键做标记）</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Marks this moment in the recording (Enter in the note)</source>
        <translation>在记录中标记此刻（在备注中按回车键）</translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation>结束记录</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Completes the file (Ctrl+R)</source>
        <translation>完成文件 (Ctrl+R)</translation>
    </message>
    <message>
        <source>Writes what is measured to a file (Ctrl+R)</source>
        <translation>把测量数据写入文件 (Ctrl+R)</translation>
    </message>
    <message>
        <source>%1 rows in %2</source>
        <translation>%2 中有 %1 行</translation>
    </message>
    <message>
        <source>What was measured, with its units; the sidecar beside it has the rest.</source>
        <translation>测量数据及其单位；旁边的附属文件包含其余信息。</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingControl</name>
    <message>
        <source>There is nothing to record.</source>
        <translation>没有可记录的内容。</translation>
    </message>
    <message>
        <source>Connect a device first.</source>
        <translation>请先连接设备。</translation>
    </message>
    <message>
        <source>%1 exists already.</source>
        <translation>%1 已存在。</translation>
    </message>
    <message>
        <source>Choose another name; recordings are not overwritten.</source>
        <translation>请换一个名称；记录不会被覆盖。</translation>
    </message>
    <message>
        <source>%1. What was written until then is in %2.</source>
        <translation>%1。此前写入的内容在 %2 中。</translation>
    </message>
</context>
<context>
    <name>halbench::app::ReferenceForm</name>
    <message>
        <source>Amplitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>Height of the step or of one stair, amplitude of sine and chirp, rms of a multisine, end of a ramp (0: no end)</source>
        <translation>阶跃或单级阶梯的高度、正弦和扫频的幅值、多正弦的有效值、斜坡的终点（0：无终点）</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>斜率</translation>
    </message>
    <message>
        <source>How fast the ramp rises; negative: backward</source>
        <translation>斜坡上升的快慢；负值：反向</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Of the sine; the first one of chirp and multisine</source>
        <translation>正弦的频率；扫频和多正弦的起始频率</translation>
    </message>
    <message>
        <source>Last frequency</source>
        <translation>终止频率</translation>
    </message>
    <message>
        <source>Where chirp and multisine end</source>
        <translation>扫频和多正弦的终止处</translation>
    </message>
    <message>
        <source>Time of a stair</source>
        <translation>每级时间</translation>
    </message>
    <message>
        <source>How long every stair is held</source>
        <translation>每级保持的时间</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>个数</translation>
    </message>
    <message>
        <source>Stairs of a staircase, lines of a multisine (at most 32)</source>
        <translation>阶梯的级数、多正弦的谱线数（最多 32）</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Phases of the multisine; 0: those that keep its peak low</source>
        <translation>多正弦的相位；0：峰值较小的一组</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基值</translation>
    </message>
    <message>
        <source>Constant motion, or constant current, added to the shape</source>
        <translation>叠加到波形上的恒定运动或恒定电流</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>持续时间</translation>
    </message>
    <message>
        <source>Then a position is held and a current goes to zero</source>
        <translation>之后位置保持，电流归零</translation>
    </message>
    <message>
        <source>Time of a plateau</source>
        <translation>每个平台的时间</translation>
    </message>
    <message>
        <source>How long every current is held</source>
        <translation>每个电流保持的时间</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>正弦</translation>
    </message>
    <message>
        <source>Staircase</source>
        <translation>阶梯</translation>
    </message>
    <message>
        <source>Chirp</source>
        <translation>扫频</translation>
    </message>
    <message>
        <source>Multisine</source>
        <translation>多正弦</translation>
    </message>
    <message>
        <source>Speed plateaus</source>
        <translation>转速平台</translation>
    </message>
    <message>
        <source>Shape of the reference</source>
        <translation>参考信号波形</translation>
    </message>
    <message>
        <source>What the board&apos;s generator adds to the set-point</source>
        <translation>控制板发生器叠加到设定值上的信号</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>波形</translation>
    </message>
    <message>
        <source>Currents of the plateaus in ampere</source>
        <translation>各平台的电流（安培）</translation>
    </message>
    <message>
        <source>Up to 32 currents in A, one after the other, with spaces or semicolons between</source>
        <translation>最多 32 个电流值（A），依次排列，用空格或分号隔开</translation>
    </message>
    <message>
        <source>Currents (A)</source>
        <translation>电流 (A)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a current.</source>
        <translation>“%1”不是电流值。</translation>
    </message>
    <message>
        <source>Write currents in A, e.g. 1.6; 2; 2.4.</source>
        <translation>请以 A 为单位输入电流，例如 1.6; 2; 2.4。</translation>
    </message>
    <message>
        <source>There are %1 plateaus.</source>
        <translation>共有 %1 个平台。</translation>
    </message>
    <message>
        <source>The board takes 1 to 32.</source>
        <translation>控制板接受 1 到 32 个。</translation>
    </message>
</context>
<context>
    <name>halbench::app::SignalTree</name>
    <message>
        <source>Signals of the device</source>
        <translation>设备信号</translation>
    </message>
    <message>
        <source>A tick plots a signal (Enter or Space); drag it onto a plot</source>
        <translation>勾选即绘制信号（回车键或空格键）；也可拖到曲线图上</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>other</source>
        <translation>其他</translation>
    </message>
</context>
<context>
    <name>halbench::app::TopBar</name>
    <message>
        <source>Arrange the panels for %1 (%2)</source>
        <translation>按“%1”布置面板 (%2)</translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation>视角 %1</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Write what is measured to a file, or end that (Ctrl+R)</source>
        <translation>把测量数据写入文件，或结束写入 (Ctrl+R)</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>连接丢失</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneForm</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>请更正或留空</translation>
    </message>
    <message>
        <source>Gains &amp;by</source>
        <translation>增益来源(&amp;B)</translation>
    </message>
    <message>
        <source>Where the gains come from</source>
        <translation>增益从何而来</translation>
    </message>
    <message>
        <source>A design method, a shipped preset, or what the device has</source>
        <translation>一种设计方法、自带的预设或设备中的值</translation>
    </message>
    <message>
        <source>Method: %1</source>
        <translation>方法：%1</translation>
    </message>
    <message>
        <source>Preset: %1</source>
        <translation>预设：%1</translation>
    </message>
    <message>
        <source>On the device now</source>
        <translation>设备当前值</translation>
    </message>
    <message>
        <source>the gains that run now</source>
        <translation>当前运行的增益</translation>
    </message>
    <message>
        <source>Edited by hand</source>
        <translation>手动编辑</translation>
    </message>
    <message>
        <source>the numbers below</source>
        <translation>下面的数值</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>阻尼比</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Bandwidth</source>
        <translation>带宽</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>What the loop shall have; empty: the method&apos;s default</source>
        <translation>回路应达到的指标；留空：该方法的默认值</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneNumberWords</name>
    <message>
        <source>infinite</source>
        <translation>无穷大</translation>
    </message>
    <message>
        <source>%1 overshoot, settled after %2</source>
        <translation>超调 %1，调节时间 %2</translation>
    </message>
    <message>
        <source>Closed loop</source>
        <translation>闭环</translation>
    </message>
    <message>
        <source>Poles of the sampled loop with the device&apos;s delay</source>
        <translation>含设备时延的采样回路的极点</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>稳定</translation>
    </message>
    <message>
        <source>UNSTABLE</source>
        <translation>不稳定</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>幅值裕度</translation>
    </message>
    <message>
        <source>Factor on the gain that makes the loop unstable; at least 2 is usual</source>
        <translation>使回路失稳的增益倍数；通常至少为 2</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>At the gain crossover; at least 30° is usual</source>
        <translation>在增益穿越频率处；通常至少 30°</translation>
    </message>
    <message>
        <source>… of 95 % of the motors</source>
        <translation>… 95 % 的电机</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>5th percentile over motors drawn from the identified uncertainty</source>
        <translation>按辨识不确定度抽取的电机的第 5 百分位</translation>
    </message>
    <message>
        <source>Unstable motors</source>
        <translation>不稳定的电机</translation>
    </message>
    <message>
        <source>Share of the motors that the data allow which this loop makes unstable</source>
        <translation>数据允许的电机中会被此回路失稳的比例</translation>
    </message>
    <message>
        <source>Gain crossover</source>
        <translation>增益穿越频率</translation>
    </message>
    <message>
        <source>Where the open loop has the gain 1</source>
        <translation>开环增益为 1 处</translation>
    </message>
    <message>
        <source>Delay margin</source>
        <translation>时延裕度</translation>
    </message>
    <message>
        <source>Dead time that uses up the phase margin</source>
        <translation>耗尽相位裕度的时延</translation>
    </message>
    <message>
        <source>Modulus margin</source>
        <translation>模裕度</translation>
    </message>
    <message>
        <source>Smallest distance of the open loop from -1; at least 0.5 is usual</source>
        <translation>开环到 -1 的最小距离；通常至少 0.5</translation>
    </message>
    <message>
        <source>Largest K_P</source>
        <translation>最大 K_P</translation>
    </message>
    <message>
        <source>Above it the sampled loop is unstable</source>
        <translation>超过此值采样回路不稳定</translation>
    </message>
    <message>
        <source>Friction band at rest</source>
        <translation>静止摩擦带</translation>
    </message>
    <message>
        <source>Friction may hold the rotor this far from its reference</source>
        <translation>摩擦可能使转子停在离参考值这么远处</translation>
    </message>
    <message>
        <source>Linear step</source>
        <translation>线性阶跃</translation>
    </message>
    <message>
        <source>Small steps, without friction and current limit</source>
        <translation>小阶跃，无摩擦和电流限制</translation>
    </message>
    <message>
        <source>Step of 100°</source>
        <translation>100° 阶跃</translation>
    </message>
    <message>
        <source>With friction and current limit</source>
        <translation>含摩擦和电流限制</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneNumbers</name>
    <message>
        <source>Prediction</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>On the device</source>
        <translation>设备中</translation>
    </message>
    <message>
        <source>Predicted figures</source>
        <translation>预测指标</translation>
    </message>
</context>
<context>
    <name>halbench::app::TunePanel</name>
    <message>
        <source>Verification: %1</source>
        <translation>验证：%1</translation>
    </message>
    <message>
        <source>No motor to tune yet</source>
        <translation>尚无可整定的电机</translation>
    </message>
    <message>
        <source>Gains are designed for an identified motor, with everything that is predicted of them, and proved by a move before they stay.</source>
        <translation>为已辨识的电机设计增益，给出全部预测，并在保留之前用一次运动加以验证。</translation>
    </message>
    <message>
        <source>Identify the motor</source>
        <translation>辨识电机</translation>
    </message>
    <message>
        <source>Apply and verify</source>
        <translation>应用并验证</translation>
    </message>
    <message>
        <source>One transaction, then a step of 29° that must go as predicted; Esc stops it</source>
        <translation>一次事务，然后做 29° 阶跃，必须与预测一致；按 Esc 键停止</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>The new gains stay until the device is switched off</source>
        <translation>新增益在设备断电之前有效</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>The gains from before run again</source>
        <translation>重新运行之前的增益</translation>
    </message>
    <message>
        <source>Save gains…</source>
        <translation>保存增益…</translation>
    </message>
    <message>
        <source>Write the file that the program&apos;s analyse reads</source>
        <translation>写出供本程序 analyse 读取的文件</translation>
    </message>
    <message>
        <source>Step of 100°</source>
        <translation>100° 阶跃</translation>
    </message>
    <message>
        <source>Small step</source>
        <translation>小阶跃</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>验证</translation>
    </message>
    <message>
        <source>Predictions</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>Identified motor (SI, 95 %): %1</source>
        <translation>已辨识电机（SI，95 %）：%1</translation>
    </message>
    <message>
        <source>Good: robustly stable</source>
        <translation>良好：鲁棒稳定</translation>
    </message>
    <message>
        <source>Doubtful: read the warnings before you apply it</source>
        <translation>存疑：应用之前请阅读警告</translation>
    </message>
    <message>
        <source>Refused: this loop is unstable</source>
        <translation>拒绝：此回路不稳定</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Writing the gains</source>
        <translation>正在写入增益</translation>
    </message>
    <message>
        <source>Cancelled; the gains from before run again.</source>
        <translation>已取消；重新运行之前的增益。</translation>
    </message>
    <message>
        <source>Applied, and the verification move went as predicted.</source>
        <translation>已应用，验证运动与预测一致。</translation>
    </message>
    <message>
        <source>Keep the new gains, or restore those from before.</source>
        <translation>请保留新增益，或恢复之前的增益。</translation>
    </message>
    <message>
        <source>Not kept, the gains from before run again: %1</source>
        <translation>未保留，重新运行之前的增益：%1</translation>
    </message>
    <message>
        <source>The gains from before run again.</source>
        <translation>重新运行之前的增益。</translation>
    </message>
    <message>
        <source>Save gains</source>
        <translation>保存增益</translation>
    </message>
    <message>
        <source>Gains (*.json)</source>
        <translation>增益 (*.json)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Picture (*.svg *.png)</source>
        <translation>图片 (*.svg *.png)</translation>
    </message>
    <message>
        <source>From the project: gains by %1.</source>
        <translation>来自项目：由 %1 得到的增益。</translation>
    </message>
    <message>
        <source>Choose a method to design anew for the motor as it is now.</source>
        <translation>选择一种方法，即可针对电机的当前状态重新设计。</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuningFigures</name>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>幅值裕度</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>开环</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>response</source>
        <translation>响应</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>参考值</translation>
    </message>
    <message>
        <source>Predicted step of 1 rad, linear loop</source>
        <translation>预测的 1 rad 阶跃，线性回路</translation>
    </message>
    <message>
        <source>friction band</source>
        <translation>摩擦带</translation>
    </message>
    <message>
        <source>Predicted step with friction and current limit,</source>
        <translation>预测阶跃（含摩擦和电流限制），</translation>
    </message>
    <message>
        <source>Verification move: measured over predicted</source>
        <translation>验证运动：实测与预测对比</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
</context>
<context>
    <name>halbench::app::WizardPanel</name>
    <message>
        <source>It could not start: no device, or it is busy.</source>
        <translation>无法启动：没有设备，或设备正忙。</translation>
    </message>
    <message>
        <source>Connect a device, or wait for the end of what runs.</source>
        <translation>请连接设备，或等待正在运行的任务结束。</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::BandItem</name>
    <message>
        <source>limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::CursorBar</name>
    <message>
        <source>Time of cursor %1</source>
        <translation>光标 %1 的时间</translation>
    </message>
    <message>
        <source>Time of cursor %1: type it, drag the line, or press %1 and move it with the arrow keys</source>
        <translation>光标 %1 的时间：直接输入、拖动竖线，或按 %1 键后用方向键移动</translation>
    </message>
    <message>
        <source>Distance of the cursors</source>
        <translation>两光标间距</translation>
    </message>
    <message>
        <source>Δt %1 s    1/Δt %2 Hz</source>
        <translation>Δt %1 s    1/Δt %2 Hz</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::EmptyState</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::EstimateTable</name>
    <message>
        <source>Quantity</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>± (95 %)</source>
        <translation>± (95 %)</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>95 % interval: %1 to %2</source>
        <translation>95 % 区间：%1 至 %2</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::FigureProbe</name>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 从 %2 到 %3</translation>
    </message>
    <message>
        <source>Against %1: %2</source>
        <translation>相对于%1：%2</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::FigureView</name>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图</translation>
    </message>
    <message>
        <source>Nothing to show yet</source>
        <translation>暂无内容</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::Figures</name>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>已剔除</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>magnitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>相位</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>估计值</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LegendTableModel</name>
    <message>
        <source>, not updated any more</source>
        <translation>，不再更新</translation>
    </message>
    <message>
        <source>%1: %2 %3%4</source>
        <translation>%1：%2 %3%4</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LiveLegend</name>
    <message>
        <source>Legend with live values</source>
        <translation>带实时数值的图例</translation>
    </message>
    <message>
        <source>Space hides or shows the chosen curve, Delete removes it from the plot.</source>
        <translation>空格键隐藏或显示所选曲线，Delete 键将其从图中移除。</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LivePlot</name>
    <message>
        <source>Drag signals here or press Insert</source>
        <translation>将信号拖到此处或按 Insert 键</translation>
    </message>
    <message>
        <source>Empty plot</source>
        <translation>空曲线图</translation>
    </message>
    <message>
        <source>Plot of %1</source>
        <translation>%1的曲线图</translation>
    </message>
    <message>
        <source>Arrow keys move a cursor, plus and minus zoom, Space pauses, F fits, Insert adds signals.</source>
        <translation>方向键移动光标，加号和减号缩放，空格键暂停，F 键适应，Insert 键添加信号。</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LivePlotStack</name>
    <message>
        <source>Live values of %1</source>
        <translation>%1的实时数值</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Freeze the view; data are kept and go on being recorded</source>
        <translation>冻结视图；数据保留并继续记录</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>Keep the newest sample in view</source>
        <translation>保持最新样本可见</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应</translation>
    </message>
    <message>
        <source>Fit the value axes; when the view stands still, show all of the history</source>
        <translation>适应数值轴；视图静止时显示全部历史</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>Show all of the history</source>
        <translation>显示全部历史</translation>
    </message>
    <message>
        <source>Zoom back</source>
        <translation>返回缩放</translation>
    </message>
    <message>
        <source>Return to the view before</source>
        <translation>返回上一个视图</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Show a shorter stretch of time</source>
        <translation>显示较短的时间段</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Show a longer stretch of time</source>
        <translation>显示较长的时间段</translation>
    </message>
    <message>
        <source>Scroll back</source>
        <translation>向后滚动</translation>
    </message>
    <message>
        <source>Show what was before</source>
        <translation>显示之前的数据</translation>
    </message>
    <message>
        <source>Scroll on</source>
        <translation>向前滚动</translation>
    </message>
    <message>
        <source>Show what came after</source>
        <translation>显示之后的数据</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>光标</translation>
    </message>
    <message>
        <source>Two cursors that measure; drag them or move them with the arrow keys</source>
        <translation>两个测量光标；拖动或用方向键移动</translation>
    </message>
    <message>
        <source>Cursor A</source>
        <translation>光标 A</translation>
    </message>
    <message>
        <source>Arrow keys move cursor A</source>
        <translation>方向键移动光标 A</translation>
    </message>
    <message>
        <source>Cursor B</source>
        <translation>光标 B</translation>
    </message>
    <message>
        <source>Arrow keys move cursor B</source>
        <translation>方向键移动光标 B</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Mark this moment</source>
        <translation>标记此刻</translation>
    </message>
    <message>
        <source>Add signals</source>
        <translation>添加信号</translation>
    </message>
    <message>
        <source>Choose signals to show</source>
        <translation>选择要显示的信号</translation>
    </message>
    <message>
        <source>Paused, data are kept (%1 s since)</source>
        <translation>已暂停，数据保留（已 %1 s）</translation>
    </message>
    <message>
        <source>Following, %1 s</source>
        <translation>跟随中，%1 s</translation>
    </message>
    <message>
        <source>Scrolled; press End to follow</source>
        <translation>已滚动；按 End 键跟随</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LogTableModel</name>
    <message>
        <source>error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>详细</translation>
    </message>
    <message>
        <source>note</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1（%2 次）</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>时间 [s]</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>级别</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LogView</name>
    <message>
        <source>Filter messages</source>
        <translation>筛选消息</translation>
    </message>
    <message>
        <source>Show only messages whose source or text contains this</source>
        <translation>仅显示来源或文字包含此内容的消息</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Notes and worse</source>
        <translation>提示及以上</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>警告和错误</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>The least important messages that are shown</source>
        <translation>显示的最低级别消息</translation>
    </message>
    <message>
        <source>Level of messages</source>
        <translation>消息级别</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the selected messages, or all that are shown (%1)</source>
        <translation>复制所选消息，或全部显示的消息 (%1)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Forget all messages</source>
        <translation>清除所有消息</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::MessageBar</name>
    <message>
        <source>Dismiss this message (Delete)</source>
        <translation>关闭此消息 (Delete)</translation>
    </message>
    <message>
        <source>Dismiss message</source>
        <translation>关闭消息</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::NumberLabel</name>
    <message>
        <source>No new value from the device: this is the last one it sent</source>
        <translation>设备没有新值：这是它最后发送的值</translation>
    </message>
    <message>
        <source>%1, old</source>
        <translation>%1，旧值</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::OptionalNumberEdit</name>
    <message>
        <source>This is not a number</source>
        <translation>这不是数字</translation>
    </message>
    <message>
        <source>At least %1</source>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>More than %1</source>
        <translation>大于 %1</translation>
    </message>
    <message>
        <source>At most %1</source>
        <translation>至多 %1</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ParameterTable</name>
    <message>
        <source>Use %1</source>
        <translation>使用 %1</translation>
    </message>
    <message>
        <source>%1 to %2 %3, default %4</source>
        <translation>%1 至 %2 %3，默认 %4</translation>
    </message>
    <message>
        <source>changes together with the other gains, in one control cycle</source>
        <translation>与其他增益在同一控制周期内一起改变</translation>
    </message>
    <message>
        <source>can only be read</source>
        <translation>只读</translation>
    </message>
    <message>
        <source>Select a parameter to read what it does.</source>
        <translation>选择一个参数以查看其作用。</translation>
    </message>
    <message>
        <source>Write changed (%1)</source>
        <translation>写入更改 (%1)</translation>
    </message>
    <message>
        <source>Write changed</source>
        <translation>写入更改</translation>
    </message>
    <message>
        <source>Write the changed values to the device and read them back</source>
        <translation>将更改的值写入设备并回读</translation>
    </message>
    <message>
        <source>Connect a device to write to it</source>
        <translation>请连接设备后再写入</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>读取</translation>
    </message>
    <message>
        <source>Read all values from the device</source>
        <translation>从设备读取所有值</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>Forget the edits: show what the device holds</source>
        <translation>放弃编辑：显示设备中的值</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>Edit every value to its default; nothing is written yet</source>
        <translation>将每个值编辑为默认值；尚未写入</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Undo the last edit</source>
        <translation>撤销上一次编辑</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Redo the edit</source>
        <translation>重做编辑</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>搜索参数</translation>
    </message>
    <message>
        <source>Search name, unit or help</source>
        <translation>搜索名称、单位或说明</translation>
    </message>
    <message>
        <source>Changed only</source>
        <translation>仅已更改</translation>
    </message>
    <message>
        <source>Show only values edited here or changed outside</source>
        <translation>仅显示在此编辑或在外部更改的值</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>deg</translation>
    </message>
    <message>
        <source>Angle unit of what is shown and typed here</source>
        <translation>此处显示和输入的角度单位</translation>
    </message>
    <message>
        <source>Angle unit</source>
        <translation>角度单位</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>F2 or typing edits the value</source>
        <translation>按 F2 或直接输入以编辑数值</translation>
    </message>
    <message>
        <source>Help on the parameter</source>
        <translation>参数说明</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ParameterTableModel</name>
    <message>
        <source>Changed outside this window: was %1, is now %2</source>
        <translation>在此窗口之外被更改：原为 %1，现为 %2</translation>
    </message>
    <message>
        <source>The device is gone; this is the last value it reported</source>
        <translation>设备已断开；这是它最后报告的值</translation>
    </message>
    <message>
        <source>Edited, not on the device yet: the device holds %1</source>
        <translation>已编辑，尚未写入设备：设备中为 %1</translation>
    </message>
    <message>
        <source>This value can only be read</source>
        <translation>此值只读</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1，%2：%3</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>编辑值</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>edit of %1</source>
        <translation>编辑 %1</translation>
    </message>
    <message>
        <source>Allowed is %1 to %2.</source>
        <translation>允许 %1 至 %2。</translation>
    </message>
    <message>
        <source>%1 can only be read.</source>
        <translation>%1 只读。</translation>
    </message>
    <message>
        <source>%1: “%2” is not a number.</source>
        <translation>%1：“%2”不是数字。</translation>
    </message>
    <message>
        <source>%1 needs a whole number, not %2.</source>
        <translation>%1 需要整数，而不是 %2。</translation>
    </message>
    <message>
        <source>%1: %2 is outside its limits.</source>
        <translation>%1：%2 超出限值。</translation>
    </message>
    <message>
        <source>revert</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>默认值</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ProgressRow</name>
    <message>
        <source>Cancelling…</source>
        <translation>正在取消…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancel and put everything back as it was</source>
        <translation>取消并恢复原状</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>剩余 %1</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::QuantityEdit</name>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 至 %2 %3</translation>
    </message>
    <message>
        <source>Allowed: %1 (arrow keys: one step, Page Up and Page Down: ten)</source>
        <translation>允许：%1（方向键：一步，Page Up 和 Page Down：十步）</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::RotorView</name>
    <message numerus="yes">
        <source>%n separate magnets</source>
        <translation>
            <numerusform>%n 个独立磁体</numerusform>
        </translation>
    </message>
    <message>
        <source>as the Hall sensors see it</source>
        <translation>霍尔传感器所见</translation>
    </message>
    <message>
        <source>ideal cylinder</source>
        <translation>理想圆筒</translation>
    </message>
    <message>
        <source>Cross-section of the rotor</source>
        <translation>转子横截面</translation>
    </message>
    <message>
        <source>rotor at %1 degrees</source>
        <translation>转子位于 %1 度</translation>
    </message>
    <message>
        <source>angle not known</source>
        <translation>角度未知</translation>
    </message>
    <message>
        <source>%1 (old); field: %2</source>
        <translation>%1（旧值）；磁场：%2</translation>
    </message>
    <message>
        <source>%1; field: %2</source>
        <translation>%1；磁场：%2</translation>
    </message>
    <message>
        <source>a</source>
        <translation>a</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>ψ %1</source>
        <translation>ψ %1</translation>
    </message>
    <message>
        <source>Phase A
%1
Phase B
%2</source>
        <translation>A 相
%1
B 相
%2</translation>
    </message>
    <message>
        <source>Hall a
%1
Hall b
%2</source>
        <translation>霍尔 a
%1
霍尔 b
%2</translation>
    </message>
    <message>
        <source>old values</source>
        <translation>旧值</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StatusStrip</name>
    <message>
        <source>Connected</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Running %1</source>
        <translation>%1 运行中</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Stopped (%1)</source>
        <translation>已停止（%1）</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Fault (%1)</source>
        <translation>故障（%1）</translation>
    </message>
    <message>
        <source>Disconnected</source>
        <translation>未连接</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>无设备</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>This device is a simulation inside the program; nothing real moves</source>
        <translation>此设备是程序内的仿真；没有真实物体运动</translation>
    </message>
    <message>
        <source>State of the device</source>
        <translation>设备状态</translation>
    </message>
    <message>
        <source>%1, simulated, %2</source>
        <translation>%1，仿真，%2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>正在记录 %1</translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation>未记录</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StepList</name>
    <message>
        <source>current</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>done with a warning</source>
        <translation>完成，有警告</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>skipped</source>
        <translation>已跳过</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1：%2。%3</translation>
    </message>
    <message>
        <source>Step %1 of %2, %3, %4</source>
        <translation>步骤 %1/%2，%3，%4</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StopButton</name>
    <message>
        <source>STOPPED — re-arm</source>
        <translation>已停止 — 解除</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Software stop: current to zero at once, latched until re-armed (Esc)</source>
        <translation>软件停止：电流立即归零，锁存直至解除 (Esc)</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>Stopped: %1.</source>
        <translation>已停止：%1。</translation>
    </message>
    <message>
        <source>%1 Re-arming is locked for a few seconds; Esc still stops.</source>
        <translation>%1 几秒内禁止解除；Esc 键仍可停止。</translation>
    </message>
    <message>
        <source>%1 Click to re-arm; set-points start at zero. Esc still stops.</source>
        <translation>%1 单击解除停止；设定值从零开始。Esc 键仍可停止。</translation>
    </message>
    <message>
        <source>Stopped, re-arm</source>
        <translation>已停止，解除</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::TimeAxisBar</name>
    <message>
        <source>Time axis</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>时间 [s]</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::VerdictView</name>
    <message>
        <source>Findings</source>
        <translation>诊断</translation>
    </message>
</context>
</TS>
