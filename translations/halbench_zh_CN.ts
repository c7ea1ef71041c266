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
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Configuration</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>XY</source>
        <translation>XY</translation>
    </message>
    <message>
        <source>Derived signals</source>
        <translation>派生信号</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>记录列表</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>频率响应</translation>
    </message>
    <message>
        <source>Relay experiment</source>
        <translation>继电实验</translation>
    </message>
    <message>
        <source>Monitor 2</source>
        <translation>监视 2</translation>
    </message>
    <message>
        <source>Monitor 3</source>
        <translation>监视 3</translation>
    </message>
</context>
<context>
    <name>Phrases</name>
    <message>
        <source>{}; move one after the other</source>
        <translation>{}；请逐个移动</translation>
    </message>
    <message>
        <source>{}; name one with --axis, in an experiment with the key &apos;axis&apos;</source>
        <translation>{}；用 --axis 指定一个，在实验文件中用键 'axis'</translation>
    </message>
    <message>
        <source>its axes are {}</source>
        <translation>其轴为 {}</translation>
    </message>
    <message>
        <source>use one of its own: {}</source>
        <translation>请使用该设备自己的步骤：{}</translation>
    </message>
    <message>
        <source>the procedure {} does not suit this device; nothing was armed</source>
        <translation>步骤 {} 不适用于此设备；没有使能任何输出</translation>
    </message>
    <message>
        <source>choose a1 and a2 with 0 &lt; a2 &lt; a1 and 4 - 2 a1 + a2 &gt; 0</source>
        <translation>请选择满足 0 &lt; a2 &lt; a1 且 4 - 2 a1 + a2 &gt; 0 的 a1 和 a2</translation>
    </message>
    <message>
        <source>correct the coefficients of the section</source>
        <translation>请更正该环节的系数</translation>
    </message>
    <message>
        <source>leave some of them out</source>
        <translation>请去掉其中一些</translation>
    </message>
    <message>
        <source>The time in row {} of the table of poses does not rise.</source>
        <translation>姿态表第 {} 行的时间没有增加。</translation>
    </message>
    <message>
        <source>Row {} of the table of poses is not finite.</source>
        <translation>姿态表第 {} 行不是有限值。</translation>
    </message>
    <message>
        <source>coil field {} of sensor {}</source>
        <translation>线圈磁场 {}，传感器 {}</translation>
    </message>
    <message>
        <source>place along {} of sensor {}</source>
        <translation>沿 {} 的位置，传感器 {}</translation>
    </message>
    <message>
        <source>frame about {} of sensor {}</source>
        <translation>绕 {} 的转角，传感器 {}</translation>
    </message>
    <message>
        <source>offset {} of sensor {}</source>
        <translation>零点偏移 {}，传感器 {}</translation>
    </message>
    <message>
        <source>skew {} of sensor {}</source>
        <translation>非正交 {}，传感器 {}</translation>
    </message>
    <message>
        <source>gain {} of sensor {}</source>
        <translation>增益 {}，传感器 {}</translation>
    </message>
    <message>
        <source>field strength {}</source>
        <translation>磁场强度 {}</translation>
    </message>
    <message>
        <source>The motion does not determine this value: {}.</source>
        <translation>运动不足以确定此值：{}。</translation>
    </message>
    <message>
        <source>Widen the region, reduce the distance or raise the range of the sensor.</source>
        <translation>请扩大区域、减小距离或提高传感器量程。</translation>
    </message>
    <message>
        <source>The constraints leave no pair of places for the sensors.</source>
        <translation>约束条件没有给传感器留下任何一对位置。</translation>
    </message>
    <message>
        <source>A placement needs sensors outside the rotor, a positive strength and noise, and at least one finalist.</source>
        <translation>布置需要传感器位于转子之外、强度和噪声为正，并至少一个入围方案。</translation>
    </message>
    <message>
        <source>Use the objective reading, or the exact device.</source>
        <translation>请使用目标 reading，或使用精确模型。</translation>
    </message>
    <message>
        <source>The additive device has no tensor to condition.</source>
        <translation>加性模型没有可评定条件数的张量。</translation>
    </message>
    <message>
        <source>The step of the placement lattice must divide 45 degrees and be at least 1 degree.</source>
        <translation>布置网格的步长必须整除 45 度且至少为 1 度。</translation>
    </message>
    <message>
        <source>harmonic ({},{})</source>
        <translation>球谐项 ({},{})</translation>
    </message>
    <message>
        <source>drift of {} with temperature</source>
        <translation>{} 随温度的漂移</translation>
    </message>
    <message>
        <source>A common rotation of all sensors cannot be told from one of the rotor: the mean turn is zero. Only a known orientation fixes it.</source>
        <translation>所有传感器的公共旋转无法与转子的旋转区分：平均转角取零。只有已知姿态才能确定它。</translation>
    </message>
    <message>
        <source>The common scale of all gains cannot be told from the strength q: their mean is one. Only a known field fixes it; it does not change the orientation.</source>
        <translation>所有增益的公共比例无法与强度 q 区分：其均值取 1。只有已知磁场才能确定它；它不影响姿态。</translation>
    </message>
    <message>
        <source>Record orientations that differ more in tilt and spin, or keep it at its nominal value.</source>
        <translation>请记录倾斜和自转差异更大的姿态，或保持其标称值。</translation>
    </message>
    <message>
        <source>The calibration was stopped.</source>
        <translation>标定已停止。</translation>
    </message>
    <message>
        <source>Turn it through the whole workspace, tilt and spin.</source>
        <translation>请使其经过整个工作范围：倾斜并自转。</translation>
    </message>
    <message>
        <source>The rotor moved by only {} degrees in the recording.</source>
        <translation>记录中转子只转动了 {} 度。</translation>
    </message>
    <message>
        <source>Nothing is selected to be calibrated.</source>
        <translation>没有选择要标定的内容。</translation>
    </message>
    <message>
        <source>A calibration needs positive deviations of readings and known orientations and at least one iteration.</source>
        <translation>标定需要读数和已知姿态的标准差为正，并至少迭代一次。</translation>
    </message>
    <message>
        <source>Record longer, with the rotor moving and no channel clipped.</source>
        <translation>请延长记录，使转子运动且没有通道饱和。</translation>
    </message>
    <message>
        <source>Only {} samples have a known orientation; the calibration needs {}.</source>
        <translation>只有 {} 个采样的姿态已知；标定需要 {} 个。</translation>
    </message>
    <message>
        <source>m, rad, N or N*m; height of a step of the staircase, end of the ramp, distance</source>
        <translation>m、rad、N 或 N*m；阶梯的单级高度，斜坡的终点，行程</translation>
    </message>
    <message>
        <source>Slope of the ramp, speed of the trapezoid, per second</source>
        <translation>斜坡每秒的变化量，梯形轨迹的速度</translation>
    </message>
    <message>
        <source>Largest acceleration of the trapezoid per second squared</source>
        <translation>梯形轨迹的最大加速度，每二次方秒</translation>
    </message>
    <message>
        <source>trapezoid</source>
        <translation>梯形</translation>
    </message>
    <message>
        <source>Pose and speed from the readings</source>
        <translation>由读数得到位姿和速度</translation>
    </message>
    <message>
        <source>Squared innovation of the tracking filter, 6 when all is well</source>
        <translation>跟踪滤波器的新息平方，正常为 6</translation>
    </message>
    <message>
        <source>least squares</source>
        <translation>最小二乘</translation>
    </message>
    <message>
        <source>tracking filter</source>
        <translation>跟踪滤波器</translation>
    </message>
    <message>
        <source>From the wrench to the currents</source>
        <translation>由力与力矩分配电流</translation>
    </message>
    <message>
        <source>set by set</source>
        <translation>逐对分配</translation>
    </message>
    <message>
        <source>heading, fundamental</source>
        <translation>考虑转角，基波</translation>
    </message>
    <message>
        <source>heading, all harmonics</source>
        <translation>考虑转角，所有谐波</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>chip</source>
        <translation>霍尔芯片</translation>
    </message>
    <message>
        <source>coil</source>
        <translation>线圈</translation>
    </message>
    <message>
        <source>platen</source>
        <translation>动子</translation>
    </message>
    <message>
        <source>length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Pose of the platen along {}</source>
        <translation>动子沿 {} 的位姿</translation>
    </message>
    <message>
        <source>Pose of the platen about the vertical</source>
        <translation>动子绕竖轴的转角</translation>
    </message>
    <message>
        <source>Speed of the platen along {}</source>
        <translation>动子沿 {} 的速度</translation>
    </message>
    <message>
        <source>Speed of the platen about the vertical</source>
        <translation>动子绕竖轴的转速</translation>
    </message>
    <message>
        <source>Reference, or effort in mode wrench, along {}</source>
        <translation>沿 {} 的参考值，力与力矩模式下为力</translation>
    </message>
    <message>
        <source>Reference, or effort in mode wrench, about the vertical</source>
        <translation>绕竖轴的参考值，力与力矩模式下为力矩</translation>
    </message>
    <message>
        <source>Force or torque of the currents along {}</source>
        <translation>电流沿 {} 产生的力</translation>
    </message>
    <message>
        <source>Force or torque of the currents about the vertical</source>
        <translation>电流绕竖轴产生的力矩</translation>
    </message>
    <message>
        <source>Current commanded into coil {}</source>
        <translation>线圈 {} 的给定电流</translation>
    </message>
    <message>
        <source>Field along x&apos; at chip {}</source>
        <translation>霍尔芯片 {} 处沿 x&apos; 的磁场</translation>
    </message>
    <message>
        <source>Field along y&apos; at chip {}</source>
        <translation>霍尔芯片 {} 处沿 y&apos; 的磁场</translation>
    </message>
    <message>
        <source>Vertical force of the coils, upward</source>
        <translation>线圈的竖直力，向上为正</translation>
    </message>
    <message>
        <source>Squared residuals of the readings over their deviation</source>
        <translation>读数残差平方与其偏差之比</translation>
    </message>
    <message>
        <source>Below 1: currents at their limit</source>
        <translation>小于 1：电流达到限值</translation>
    </message>
    <message>
        <source>Pitches from the first cell along {}</source>
        <translation>沿 {} 距起始单元的节距数</translation>
    </message>
    <message>
        <source>1, 2, 4: chips that are not used, added</source>
        <translation>1、2、4：未使用的霍尔芯片之和</translation>
    </message>
    <message>
        <source>The first cell was chosen</source>
        <translation>已选定起始单元</translation>
    </message>
    <message>
        <source>coil currents</source>
        <translation>线圈电流</translation>
    </message>
    <message>
        <source>wrench</source>
        <translation>力与力矩</translation>
    </message>
    <message>
        <source>pose jumped</source>
        <translation>位姿跳变</translation>
    </message>
    <message>
        <source>sensors determine no pose</source>
        <translation>传感器无法确定位姿</translation>
    </message>
    <message>
        <source>vertical force near the weight</source>
        <translation>竖直力接近重力</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Derivative gain on the measured speed</source>
        <translation>对实测速度的微分增益</translation>
    </message>
    <message>
        <source>Part of a step that the proportional gain sees</source>
        <translation>比例增益所作用的阶跃份额</translation>
    </message>
    <message>
        <source>Effort per acceleration of a profile</source>
        <translation>轨迹单位加速度所需的力或力矩</translation>
    </message>
    <message>
        <source>Moving mass</source>
        <translation>运动质量</translation>
    </message>
    <message>
        <source>Inertia about the vertical</source>
        <translation>绕竖轴的转动惯量</translation>
    </message>
    <message>
        <source>Centre of mass in platen axes</source>
        <translation>动子坐标系中的质心</translation>
    </message>
    <message>
        <source>Force per ampere; negative by the sign of the phases</source>
        <translation>每安培的力；因相位符号为负</translation>
    </message>
    <message>
        <source>Pitch of the magnet matrix</source>
        <translation>磁体阵列的节距</translation>
    </message>
    <message>
        <source>Width of a coil&apos;s winding</source>
        <translation>线圈绕组的宽度</translation>
    </message>
    <message>
        <source>Place of coils 5 and 6 along y&apos;</source>
        <translation>线圈 5 和 6 沿 y&apos; 的位置</translation>
    </message>
    <message>
        <source>Time constant of the speeds</source>
        <translation>速度估计的时间常数</translation>
    </message>
    <message>
        <source>Largest current of a coil</source>
        <translation>单个线圈的最大电流</translation>
    </message>
    <message>
        <source>Vertical force that trips</source>
        <translation>触发保护的竖直力</translation>
    </message>
    <message>
        <source>Largest excursion from where the mode began</source>
        <translation>自模式开始起的最大偏移</translation>
    </message>
    <message>
        <source>Largest rotation from where the mode began</source>
        <translation>自模式开始起的最大转角</translation>
    </message>
    <message>
        <source>Largest speed of rotation while armed</source>
        <translation>使能时的最大转速</translation>
    </message>
    <message>
        <source>Delay of the currents</source>
        <translation>电流的延迟</translation>
    </message>
    <message>
        <source>Field amplitude at the chip</source>
        <translation>霍尔芯片处的磁场幅值</translation>
    </message>
    <message>
        <source>Place of the chip in platen axes</source>
        <translation>霍尔芯片在动子坐标系中的位置</translation>
    </message>
    <message>
        <source>Error of the sensitivity along x&apos;</source>
        <translation>沿 x&apos; 的灵敏度误差</translation>
    </message>
    <message>
        <source>Error of the sensitivity along y&apos;</source>
        <translation>沿 y&apos; 的灵敏度误差</translation>
    </message>
    <message>
        <source>Share of the field along y&apos; in the reading of x&apos;</source>
        <translation>x&apos; 读数中 y&apos; 磁场的份额</translation>
    </message>
    <message>
        <source>Share of the field along x&apos; in the reading of y&apos;</source>
        <translation>y&apos; 读数中 x&apos; 磁场的份额</translation>
    </message>
    <message>
        <source>Offset of the reading of x&apos;</source>
        <translation>x&apos; 读数的零偏</translation>
    </message>
    <message>
        <source>Offset of the reading of y&apos;</source>
        <translation>y&apos; 读数的零偏</translation>
    </message>
    <message>
        <source>Field of coil 1 ... 6 at chip 1 along x&apos;, along y&apos;, at chip 2, ...</source>
        <translation>线圈 1 ... 6 在芯片 1 处沿 x&apos;、沿 y&apos;、在芯片 2 处……的磁场</translation>
    </message>
    <message>
        <source>Deviation of a reading: noise and what calibration leaves</source>
        <translation>读数的偏差：噪声和标定残差</translation>
    </message>
    <message>
        <source>m from where the mode began, or N</source>
        <translation>自模式开始起的 m，或 N</translation>
    </message>
    <message>
        <source>rad from where the mode began, or N*m</source>
        <translation>自模式开始起的 rad，或 N*m</translation>
    </message>
    <message>
        <source>Current of one coil in mode coil currents</source>
        <translation>线圈电流模式下单个线圈的电流</translation>
    </message>
    <message>
        <source>1 counts cells from the present one</source>
        <translation>1：从当前单元开始计数</translation>
    </message>
    <message>
        <source>Constant speed added in mode position, else effort</source>
        <translation>位置模式下叠加的恒定速度，否则为力或力矩</translation>
    </message>
    <message>
        <source>force constant</source>
        <translation>力常数</translation>
    </message>
    <message>
        <source>Planar six-coil positioner</source>
        <translation>六线圈平面定位台</translation>
    </message>
    <message>
        <source>True pose along x, known to the simulation only</source>
        <translation>沿 x 的真实位姿，仅仿真可知</translation>
    </message>
    <message>
        <source>True pose along y, known to the simulation only</source>
        <translation>沿 y 的真实位姿，仅仿真可知</translation>
    </message>
    <message>
        <source>True rotation, known to the simulation only</source>
        <translation>真实转角，仅仿真可知</translation>
    </message>
    <message>
        <source>True speed along x, known to the simulation only</source>
        <translation>沿 x 的真实速度，仅仿真可知</translation>
    </message>
    <message>
        <source>True speed along y, known to the simulation only</source>
        <translation>沿 y 的真实速度，仅仿真可知</translation>
    </message>
    <message>
        <source>True speed of rotation, known to the simulation only</source>
        <translation>真实转速，仅仿真可知</translation>
    </message>
    <message>
        <source>True force of the coils along x, known to the simulation only</source>
        <translation>线圈沿 x 的真实力，仅仿真可知</translation>
    </message>
    <message>
        <source>True force of the coils along y, known to the simulation only</source>
        <translation>线圈沿 y 的真实力，仅仿真可知</translation>
    </message>
    <message>
        <source>True torque of the coils, known to the simulation only</source>
        <translation>线圈的真实力矩，仅仿真可知</translation>
    </message>
    <message>
        <source>check the link</source>
        <translation>检查链路</translation>
    </message>
    <message>
        <source>deg is an angle: degrees Celsius are written degC</source>
        <translation>deg 是角度：摄氏度应写作 degC</translation>
    </message>
    <message>
        <source>name the column after what it is, e.g. {}; halbench import --unit says the unit</source>
        <translation>按实际内容命名该列，例如 {}；halbench import --unit 可指定单位</translation>
    </message>
    <message>
        <source>{}:1: column &apos;{}&apos; is in &apos;{}&apos;, but {} is in {}</source>
        <translation>{}:1: 列“{}”的单位是“{}”，但 {} 的单位是 {}</translation>
    </message>
    <message>
        <source>{}: signals[{}].unit: &apos;{}&apos; contradicts the column &apos;{}&apos;</source>
        <translation>{}: signals[{}].unit：“{}”与列“{}”矛盾</translation>
    </message>
    <message>
        <source>correct the unit, or remove the sidecar to read the data without it</source>
        <translation>改正单位，或移除附属文件后再读取数据</translation>
    </message>
    <message>
        <source>unit of column &apos;{}&apos; in &apos;{}&apos;: deg is an angle; degrees Celsius are written degC</source>
        <translation>列“{}”（“{}”）的单位：deg 是角度；摄氏度应写作 degC</translation>
    </message>
    <message>
        <source>unit of column &apos;{}&apos; in &apos;{}&apos;: none is written, {} is assumed</source>
        <translation>列“{}”（“{}”）的单位：未写明，按 {} 处理</translation>
    </message>
    <message>
        <source>is {}, but the parameters say {}/{} = {}</source>
        <translation>为 {}，但参数给出 {}/{} = {}</translation>
    </message>
    <message>
        <source>the values of a model belong together: identify again with --given, e.g. &apos;halbench identify FILE.csv --given J=5.5e-4 --out&apos;</source>
        <translation>模型的各个值相互关联：请用 --given 重新辨识，例如“halbench identify FILE.csv --given J=5.5e-4 --out”</translation>
    </message>
    <message>
        <source>{}: &quot;parameters[{}]</source>
        <translation>{}: &quot;parameters[{}]</translation>
    </message>
    <message>
        <source>{} of the recording is in {}, not in {}</source>
        <translation>记录中的 {} 单位是 {}，不是 {}</translation>
    </message>
    <message>
        <source>a motor is identified from its angle and its current</source>
        <translation>电机由其角度和电流辨识</translation>
    </message>
    <message>
        <source>Rotor angle, unwrapped</source>
        <translation>转子角度，跨圈累计</translation>
    </message>
    <message>
        <source>Rotor speed, slope over 32 ms</source>
        <translation>转子转速，32 ms 内的斜率</translation>
    </message>
    <message>
        <source>Reference: rad in mode position, else A</source>
        <translation>参考值：位置模式下为 rad，否则为 A</translation>
    </message>
    <message>
        <source>Current amplitude commanded</source>
        <translation>电流幅值指令</translation>
    </message>
    <message>
        <source>Current commanded into phase {}</source>
        <translation>{} 相电流指令</translation>
    </message>
    <message>
        <source>Field at Hall sensor {}, not corrected</source>
        <translation>霍尔传感器 {} 处的磁场，未校正</translation>
    </message>
    <message>
        <source>Coil {}</source>
        <translation>线圈 {}</translation>
    </message>
    <message>
        <source>State of the board</source>
        <translation>控制板状态</translation>
    </message>
    <message>
        <source>Latched fault</source>
        <translation>已锁存的故障</translation>
    </message>
    <message>
        <source>Control cycles that saw a mixed parameter set</source>
        <translation>遇到混合参数组的控制周期数</translation>
    </message>
    <message>
        <source>Step or plateau, 0 = not running</source>
        <translation>阶梯或平台序号，0 = 未运行</translation>
    </message>
    <message>
        <source>1 while the generator runs</source>
        <translation>发生器运行时为 1</translation>
    </message>
    <message>
        <source>State of the capture</source>
        <translation>捕获状态</translation>
    </message>
    <message>
        <source>Device time of the trigger sample</source>
        <translation>触发样本的设备时间</translation>
    </message>
    <message>
        <source>Proportional gain</source>
        <translation>比例增益</translation>
    </message>
    <message>
        <source>Integral gain</source>
        <translation>积分增益</translation>
    </message>
    <message>
        <source>Derivative gain on the measured angle</source>
        <translation>作用于测得角度的微分增益</translation>
    </message>
    <message>
        <source>Set-point weight b of the proportional part</source>
        <translation>比例部分的设定值权重 b</translation>
    </message>
    <message>
        <source>Set-point weight c of the derivative part</source>
        <translation>微分部分的设定值权重 c</translation>
    </message>
    <message>
        <source>Time constant of the derivative&apos;s filter</source>
        <translation>微分滤波器的时间常数</translation>
    </message>
    <message>
        <source>Filter section (b0 d^2 + b1 d + b2)/(d^2 + a1 d + a2), d = z - 1</source>
        <translation>滤波环节 (b0 d^2 + b1 d + b2)/(d^2 + a1 d + a2)，d = z - 1</translation>
    </message>
    <message>
        <source>Coefficient b1 of the filter section</source>
        <translation>滤波环节的系数 b1</translation>
    </message>
    <message>
        <source>Coefficient b2 of the filter section</source>
        <translation>滤波环节的系数 b2</translation>
    </message>
    <message>
        <source>Coefficient a1 of the filter section; 0 switches it off</source>
        <translation>滤波环节的系数 a1；0 表示关闭</translation>
    </message>
    <message>
        <source>Coefficient a2 of the filter section</source>
        <translation>滤波环节的系数 a2</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>滤波器</translation>
    </message>
    <message>
        <source>0.9 K_f/phi, with the reference speed</source>
        <translation>0.9 K_f/phi，随参考转速的方向</translation>
    </message>
    <message>
        <source>Reference speed of full Coulomb feed-forward</source>
        <translation>库仑摩擦前馈达到满值的参考转速</translation>
    </message>
    <message>
        <source>Friction help at rest, 0.9 K_f/phi</source>
        <translation>静止时的摩擦补偿，0.9 K_f/phi</translation>
    </message>
    <message>
        <source>Error above which the friction help acts (0.16 degrees)</source>
        <translation>误差超过此值时摩擦补偿起作用（0.16 度）</translation>
    </message>
    <message>
        <source>Reference speed below which the friction help acts</source>
        <translation>参考转速低于此值时摩擦补偿起作用</translation>
    </message>
    <message>
        <source>Form of the control law</source>
        <translation>控制律形式</translation>
    </message>
    <message>
        <source>Largest current amplitude</source>
        <translation>最大电流幅值</translation>
    </message>
    <message>
        <source>Coil temperature that trips</source>
        <translation>触发保护的线圈温度</translation>
    </message>
    <message>
        <source>Largest excursion from the position at arming</source>
        <translation>相对使能时位置的最大偏移</translation>
    </message>
    <message>
        <source>Position window</source>
        <translation>位置窗口</translation>
    </message>
    <message>
        <source>Largest speed while armed</source>
        <translation>使能时的最大转速</translation>
    </message>
    <message>
        <source>Speed window</source>
        <translation>转速窗口</translation>
    </message>
    <message>
        <source>Subtract the field of the phase currents</source>
        <translation>减去相电流产生的磁场</translation>
    </message>
    <message>
        <source>Field of a phase current at its own sensor</source>
        <translation>相电流在其自身传感器处的磁场</translation>
    </message>
    <message>
        <source>Angle from the two fields</source>
        <translation>由两个磁场求角度</translation>
    </message>
    <message>
        <source>Delay of the position loop in its samples</source>
        <translation>位置回路的时延（样本数）</translation>
    </message>
    <message>
        <source>Commutate every n-th millisecond</source>
        <translation>每 n 毫秒换相一次</translation>
    </message>
    <message>
        <source>Commutation angle ahead by speed times this</source>
        <translation>换相角超前量 = 转速乘以此值</translation>
    </message>
    <message>
        <source>Offset of channel {}</source>
        <translation>通道 {} 的偏置</translation>
    </message>
    <message>
        <source>Amplitude of channel B over channel A</source>
        <translation>通道 B 与通道 A 的幅值比</translation>
    </message>
    <message>
        <source>Channel B sees sin(angle + quadrature)</source>
        <translation>通道 B 测得 sin(角度 + 正交误差)</translation>
    </message>
    <message>
        <source>Field amplitude at the sensors</source>
        <translation>传感器处的磁场幅值</translation>
    </message>
    <message>
        <source>Angle error map</source>
        <translation>角度误差表</translation>
    </message>
    <message>
        <source>Angle error map, cosine of order {}</source>
        <translation>角度误差表，{} 阶余弦</translation>
    </message>
    <message>
        <source>Angle error map, sine of order {}</source>
        <translation>角度误差表，{} 阶正弦</translation>
    </message>
    <message>
        <source>Arm the outputs</source>
        <translation>使能输出</translation>
    </message>
    <message>
        <source>What the set-point means</source>
        <translation>设定值的含义</translation>
    </message>
    <message>
        <source>A, or rad from the position at arming</source>
        <translation>A，或相对使能时位置的 rad</translation>
    </message>
    <message>
        <source>Silence of the host that stops the board</source>
        <translation>主机静默超过此时间则控制板停止</translation>
    </message>
    <message>
        <source>Write 1 to stop and latch</source>
        <translation>写入 1 停止并锁存</translation>
    </message>
    <message>
        <source>A lost master brings this calibration back</source>
        <translation>主机失联时恢复此参数组</translation>
    </message>
    <message>
        <source>Shape of the reference</source>
        <translation>参考信号波形</translation>
    </message>
    <message>
        <source>rad or A; height of one step of the staircase, end of the ramp</source>
        <translation>rad 或 A；阶梯一级的高度，斜坡的终值</translation>
    </message>
    <message>
        <source>Slope of the ramp, rad/s or A/s</source>
        <translation>斜坡斜率，rad/s 或 A/s</translation>
    </message>
    <message>
        <source>Frequency of sine; first of chirp and multisine</source>
        <translation>正弦频率；扫频和多正弦的起始频率</translation>
    </message>
    <message>
        <source>Last frequency of chirp and multisine</source>
        <translation>扫频和多正弦的终止频率</translation>
    </message>
    <message>
        <source>Time of one step of the staircase</source>
        <translation>阶梯每级的时间</translation>
    </message>
    <message>
        <source>Steps of the staircase, lines of the multisine</source>
        <translation>阶梯级数，多正弦谱线数</translation>
    </message>
    <message>
        <source>Time until the generator ends</source>
        <translation>发生器运行的时间</translation>
    </message>
    <message>
        <source>Constant motion added: rad/s in mode position, else A</source>
        <translation>叠加的恒定运动：位置模式下为 rad/s，否则为 A</translation>
    </message>
    <message>
        <source>Phases of the multisine; 0 = Schroeder</source>
        <translation>多正弦相位；0 = Schroeder 相位</translation>
    </message>
    <message>
        <source>Number of plateaus</source>
        <translation>平台数</translation>
    </message>
    <message>
        <source>Time of one plateau</source>
        <translation>每个平台的时间</translation>
    </message>
    <message>
        <source>Signal of channel {} as handle (address/8), 255 = none</source>
        <translation>通道 {} 的信号编号（地址/8），255 = 无</translation>
    </message>
    <message>
        <source>What starts the capture</source>
        <translation>捕获的触发方式</translation>
    </message>
    <message>
        <source>Handle of the signal compared with the level</source>
        <translation>与电平比较的信号编号</translation>
    </message>
    <message>
        <source>Level of the trigger</source>
        <translation>触发电平</translation>
    </message>
    <message>
        <source>Direction of the crossing</source>
        <translation>穿越方向</translation>
    </message>
    <message>
        <source>Samples before the trigger</source>
        <translation>触发前的样本数</translation>
    </message>
    <message>
        <source>Milliseconds per sample</source>
        <translation>每个样本的毫秒数</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>feedforward</source>
        <translation>前馈</translation>
    </message>
    <message>
        <source>stiction</source>
        <translation>摩擦补偿</translation>
    </message>
    <message>
        <source>control</source>
        <translation>控制</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>stray</source>
        <translation>杂散磁场</translation>
    </message>
    <message>
        <source>decode</source>
        <translation>角度解码</translation>
    </message>
    <message>
        <source>delay</source>
        <translation>时延</translation>
    </message>
    <message>
        <source>commutation</source>
        <translation>换相</translation>
    </message>
    <message>
        <source>hall</source>
        <translation>霍尔传感器</translation>
    </message>
    <message>
        <source>errormap</source>
        <translation>角度误差表</translation>
    </message>
    <message>
        <source>hb</source>
        <translation>控制板</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>参考信号发生器</translation>
    </message>
    <message>
        <source>plateau</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>capture</source>
        <translation>捕获</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>disarmed</source>
        <translation>未使能</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>使能</translation>
    </message>
    <message>
        <source>disarm</source>
        <translation>禁用</translation>
    </message>
    <message>
        <source>stopped by command</source>
        <translation>由命令停止</translation>
    </message>
    <message>
        <source>stopped by watchdog</source>
        <translation>由看门狗停止</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>coil temperature above its limit</source>
        <translation>线圈温度超过限值</translation>
    </message>
    <message>
        <source>current above its limit</source>
        <translation>电流超过限值</translation>
    </message>
    <message>
        <source>speed above its window</source>
        <translation>转速超出窗口</translation>
    </message>
    <message>
        <source>position left its window</source>
        <translation>位置超出窗口</translation>
    </message>
    <message>
        <source>angle jumped (ambiguous decode)</source>
        <translation>角度跳变（解码不唯一）</translation>
    </message>
    <message>
        <source>sensor out of range</source>
        <translation>传感器超出范围</translation>
    </message>
    <message>
        <source>value not finite</source>
        <translation>数值不是有限数</translation>
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
        <source>positional</source>
        <translation>位置式</translation>
    </message>
    <message>
        <source>literal difference equation</source>
        <translation>原文差分方程</translation>
    </message>
    <message>
        <source>literal with clamped memory</source>
        <translation>原文差分方程，限幅记忆</translation>
    </message>
    <message>
        <source>arctangent</source>
        <translation>反正切</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>one sample</source>
        <translation>一个样本</translation>
    </message>
    <message>
        <source>two samples</source>
        <translation>两个样本</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>d-axis</source>
        <translation>d 轴</translation>
    </message>
    <message>
        <source>run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>正弦</translation>
    </message>
    <message>
        <source>staircase</source>
        <translation>阶梯</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>扫频</translation>
    </message>
    <message>
        <source>multisine</source>
        <translation>多正弦</translation>
    </message>
    <message>
        <source>plateaus</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>filling</source>
        <translation>填充中</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>full</source>
        <translation>已满</translation>
    </message>
    <message>
        <source>immediate</source>
        <translation>立即</translation>
    </message>
    <message>
        <source>level</source>
        <translation>电平</translation>
    </message>
    <message>
        <source>reference start</source>
        <translation>参考信号启动</translation>
    </message>
    <message>
        <source>rising</source>
        <translation>上升</translation>
    </message>
    <message>
        <source>falling</source>
        <translation>下降</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>角度</translation>
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
        <source>voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>transconductance</source>
        <translation>跨导</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>转矩</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>转动惯量</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>电阻</translation>
    </message>
    <message>
        <source>inductance</source>
        <translation>电感</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>比值</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>度</translation>
    </message>
    <message>
        <source>its</source>
        <translation>其</translation>
    </message>
    <message>
        <source>their</source>
        <translation>其</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>Designed: damping 0.06 at 15 rad/s, computed correctly</source>
        <translation>设计值：阻尼 0.06，15 rad/s，正确计算</translation>
    </message>
    <message>
        <source>Micro-step: error in degrees, 5 A/deg, 0.05 A/(deg s)</source>
        <translation>微步：误差以度计，5 A/°，0.05 A/(°·s)</translation>
    </message>
    <message>
        <source>Published gains read in degrees: 10 A/deg, 0.1 A/(deg s)</source>
        <translation>已发表的增益按度理解：10 A/°，0.1 A/(°·s)</translation>
    </message>
    <message>
        <source>Published: 10 A/rad, 0.1 A/(rad s)</source>
        <translation>已发表：10 A/rad，0.1 A/(rad s)</translation>
    </message>
    <message>
        <source>Recommended: feed-forward and micro-step assist</source>
        <translation>推荐：前馈和微步辅助</translation>
    </message>
    <message>
        <source>Two-phase Halbach-cylinder motor</source>
        <translation>两相 Halbach 圆筒电机</translation>
    </message>
    <message>
        <source>the feedback closes an algebraic loop with 1 + L = 0</source>
        <translation>反馈形成 1 + L = 0 的代数环</translation>
    </message>
    <message>
        <source>a step response needs at least two samples, each with its time</source>
        <translation>阶跃响应至少需要两个带时间的样本</translation>
    </message>
    <message>
        <source>the step response holds a value that is not finite</source>
        <translation>阶跃响应含有非有限值</translation>
    </message>
    <message>
        <source>the step has no height</source>
        <translation>阶跃没有高度</translation>
    </message>
    <message>
        <source>the times of the step response are not ascending</source>
        <translation>阶跃响应的时间没有递增</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; is read only</source>
        <translation>参数“{}”只读</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>请去掉它</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; needs a finite number</source>
        <translation>参数“{}”需要有限数</translation>
    </message>
    <message>
        <source>give a value from {} to {} {}</source>
        <translation>请给出 {} 到 {} {} 的值</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; = {} {} is out of range</source>
        <translation>参数“{}”= {} {} 超出范围</translation>
    </message>
    <message>
        <source>allowed is {} to {} {}</source>
        <translation>允许 {} 到 {} {}</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; = {} needs a whole number</source>
        <translation>参数“{}”= {} 需要整数</translation>
    </message>
    <message>
        <source>allowed is {} to {}</source>
        <translation>允许 {} 到 {}</translation>
    </message>
    <message>
        <source>count or state</source>
        <translation>计数或状态</translation>
    </message>
    <message>
        <source>angular speed</source>
        <translation>角速度</translation>
    </message>
    <message>
        <source>angular acceleration</source>
        <translation>角加速度</translation>
    </message>
    <message>
        <source>flux density</source>
        <translation>磁通密度</translation>
    </message>
    <message>
        <source>stray field per current</source>
        <translation>单位电流杂散磁场</translation>
    </message>
    <message>
        <source>temperature difference</source>
        <translation>温差</translation>
    </message>
    <message>
        <source>torque constant</source>
        <translation>转矩常数</translation>
    </message>
    <message>
        <source>viscous damping</source>
        <translation>粘性阻尼</translation>
    </message>
    <message>
        <source>acceleration per current</source>
        <translation>单位电流加速度</translation>
    </message>
    <message>
        <source>proportional gain</source>
        <translation>比例增益</translation>
    </message>
    <message>
        <source>integral gain</source>
        <translation>积分增益</translation>
    </message>
    <message>
        <source>derivative gain</source>
        <translation>微分增益</translation>
    </message>
    <message>
        <source>acceleration feed-forward</source>
        <translation>加速度前馈</translation>
    </message>
    <message>
        <source>current slope</source>
        <translation>电流变化率</translation>
    </message>
    <message>
        <source>zeta = {} at {} rad/s is out of reach of a PI position loop on this motor: zeta &lt;= c/(2 J omega) = {}</source>
        <translation>此电机的 PI 位置回路无法达到 zeta = {}（{} rad/s）：zeta &lt;= c/(2 J omega) = {}</translation>
    </message>
    <message>
        <source>lower zeta or omega, or use method bandwidth or phase-margin, which add derivative action</source>
        <translation>请降低 zeta 或 omega，或使用带微分作用的方法 bandwidth 或 phase-margin</translation>
    </message>
    <message>
        <source>method bandwidth needs a target bandwidth</source>
        <translation>方法 bandwidth 需要目标带宽</translation>
    </message>
    <message>
        <source>add --bandwidth-hz HZ</source>
        <translation>请加上 --bandwidth-hz HZ</translation>
    </message>
    <message>
        <source>a bandwidth of {} Hz is not possible with this motor at {} Hz sampling and {} samples of delay</source>
        <translation>在 {1} Hz 采样、{2} 个样本时延下，此电机无法达到 {0} Hz 带宽</translation>
    </message>
    <message>
        <source>choose {} to {} Hz</source>
        <translation>请选择 {} 到 {} Hz</translation>
    </message>
    <message>
        <source>method phase-margin needs a target margin</source>
        <translation>方法 phase-margin 需要目标裕度</translation>
    </message>
    <message>
        <source>add --phase-margin-deg DEG</source>
        <translation>请加上 --phase-margin-deg DEG</translation>
    </message>
    <message>
        <source>no position loop on this motor has a phase margin of {} deg and a gain margin of 2{}</source>
        <translation>此电机的任何位置回路都不能达到 {} 度的相位裕度和 2 倍的幅值裕度{}</translation>
    </message>
    <message>
        <source> at {} rad/s</source>
        <translation>（在 {} rad/s）</translation>
    </message>
    <message>
        <source>ask for 30 to 60 deg, or leave the crossover to the program</source>
        <translation>请要求 30 到 60 度，或由程序选择穿越频率</translation>
    </message>
    <message>
        <source>the target {} is not a finite number</source>
        <translation>目标 {} 不是有限数</translation>
    </message>
    <message>
        <source>method {} does not read the target {}</source>
        <translation>方法 {} 不使用目标 {}</translation>
    </message>
    <message>
        <source>leave it out, or choose the method that reads it</source>
        <translation>请去掉它，或选择使用它的方法</translation>
    </message>
    <message>
        <source>there is no design method &apos;{}&apos;</source>
        <translation>没有设计方法“{}”</translation>
    </message>
    <message>
        <source>choose one of: {}</source>
        <translation>请选择其一：{}</translation>
    </message>
    <message>
        <source>PI with the asked dominant pair, as far as the motor damps</source>
        <translation>具有所要求主导极点对的 PI，以电机阻尼所及为限</translation>
    </message>
    <message>
        <source>the recommended shape at the asked closed-loop bandwidth</source>
        <translation>具有所要求闭环带宽的推荐结构</translation>
    </message>
    <message>
        <source>the stiffest loop with the asked phase margin</source>
        <translation>具有所要求相位裕度的最硬回路</translation>
    </message>
    <message>
        <source>10 A/rad and 0.1 A/(rad s), as printed</source>
        <translation>10 A/rad 和 0.1 A/(rad s)，按所印</translation>
    </message>
    <message>
        <source>zeta = 0.06 at 15 rad/s, as the source meant it</source>
        <translation>zeta = 0.06，15 rad/s，按文献原意</translation>
    </message>
    <message>
        <source>5 A/deg and 0.05 A/(deg s), for steps of a few tenths of a degree</source>
        <translation>5 A/° 和 0.05 A/(°·s)，用于零点几度的阶跃</translation>
    </message>
    <message>
        <source>the printed numbers read per degree; large steps end in a limit cycle</source>
        <translation>所印数值按每度理解；大阶跃将陷入极限环</translation>
    </message>
    <message>
        <source>a step needs a finite height that is not zero</source>
        <translation>阶跃需要非零的有限高度</translation>
    </message>
    <message>
        <source>a step response of {} s is not possible</source>
        <translation>{} s 的阶跃响应不可行</translation>
    </message>
    <message>
        <source>the step response of this unstable loop grows beyond all numbers</source>
        <translation>此不稳定回路的阶跃响应无限增长</translation>
    </message>
    <message>
        <source>an integral time of zero is an infinite integral gain</source>
        <translation>积分时间为零意味着积分增益无穷大</translation>
    </message>
    <message>
        <source>no integral action is an infinite integral time</source>
        <translation>无积分作用即积分时间无穷大</translation>
    </message>
    <message>
        <source>a controller without proportional gain cannot be written with times</source>
        <translation>没有比例增益的控制器不能写成时间形式</translation>
    </message>
    <message>
        <source>keep the parallel form</source>
        <translation>请保持并联形式</translation>
    </message>
    <message>
        <source>the series form has real zeros only, these gains have complex ones (T_i &lt; 4 T_d)</source>
        <translation>串联形式只有实零点，而这些增益有复零点（T_i &lt; 4 T_d）</translation>
    </message>
    <message>
        <source>keep the parallel or the standard form</source>
        <translation>请保持并联或标准形式</translation>
    </message>
    <message>
        <source>a gain is not a finite number</source>
        <translation>某个增益不是有限数</translation>
    </message>
    <message>
        <source>a constant of the motor model is not a finite number</source>
        <translation>电机模型的某个常数不是有限数</translation>
    </message>
    <message>
        <source>phi/J = {}, c/J = {}, K_f/phi = {} is no motor: torque per ampere must be positive, damping and friction not negative</source>
        <translation>phi/J = {}、c/J = {}、K_f/phi = {} 不是电机：单位电流转矩必须为正，阻尼和摩擦不能为负</translation>
    </message>
    <message>
        <source>a delay of {} samples is not between 0 and {}</source>
        <translation>{} 个样本的时延不在 0 和 {} 之间</translation>
    </message>
    <message>
        <source>the covariance of the model is not a covariance</source>
        <translation>模型的协方差不是合法的协方差</translation>
    </message>
    <message>
        <source>it must be symmetric and positive semi-definite: identify the motor again</source>
        <translation>它必须对称且半正定：请重新辨识电机</translation>
    </message>
    <message>
        <source>{} draws are not between {} and {}</source>
        <translation>{} 次抽样不在 {} 和 {} 之间</translation>
    </message>
    <message>
        <source>the covariance does not have the size of the parameters</source>
        <translation>协方差的大小与参数不符</translation>
    </message>
    <message>
        <source>the model or its covariance holds a value that is not finite</source>
        <translation>模型或其协方差含有非有限值</translation>
    </message>
    <message>
        <source>the added inertia must be more than zero</source>
        <translation>附加惯量必须大于零</translation>
    </message>
    <message>
        <source>give it in kg*m^2, e.g. 2e-4</source>
        <translation>请以 kg*m^2 给出，例如 2e-4</translation>
    </message>
    <message>
        <source>the added inertia does not show above the errors of both runs</source>
        <translation>附加惯量的影响未超过两次测量的误差</translation>
    </message>
    <message>
        <source>fix a larger known inertia to the rotor, about as large as the rotor&apos;s own, and check that the first run was made without it</source>
        <translation>请在转子上固定更大的已知惯量，约与转子自身相当，并确认第一次测量时没有装它</translation>
    </message>
    <message>
        <source>no repeated points to judge the model by</source>
        <translation>没有可用来评判模型的重复点</translation>
    </message>
    <message>
        <source>visit some currents twice</source>
        <translation>请对某些电流测两次</translation>
    </message>
    <message>
        <source>all motion that could be used was under one current (coast-downs are missing or too short): torque and friction cannot be told apart</source>
        <translation>所有可用的运动都在同一电流下（缺少自由减速或太短）：无法区分转矩与摩擦</translation>
    </message>
    <message>
        <source>spin faster before the coast-down, or add a second current</source>
        <translation>请在自由减速前转得更快，或增加第二个电流</translation>
    </message>
    <message>
        <source>the d-axis current does not change</source>
        <translation>d 轴电流没有变化</translation>
    </message>
    <message>
        <source>step it to both signs</source>
        <translation>请使其正负阶跃</translation>
    </message>
    <message>
        <source>the ramp is too short</source>
        <translation>斜坡太短</translation>
    </message>
    <message>
        <source>record it from its start</source>
        <translation>请从其开始记录</translation>
    </message>
    <message>
        <source>the rotor did not break loose during the ramp</source>
        <translation>转子在斜坡期间没有起动</translation>
    </message>
    <message>
        <source>ramp to a higher current, from rest</source>
        <translation>请从静止升到更大的电流</translation>
    </message>
    <message>
        <source>turn the rotor through several whole turns</source>
        <translation>请将转子转动数整圈</translation>
    </message>
    <message>
        <source>the Hall readings do not change</source>
        <translation>霍尔读数没有变化</translation>
    </message>
    <message>
        <source>the Hall readings do not lie on an ellipse</source>
        <translation>霍尔读数不在椭圆上</translation>
    </message>
    <message>
        <source>too few Hall readings for an ellipse</source>
        <translation>霍尔读数太少，不足以拟合椭圆</translation>
    </message>
    <message>
        <source>record longer</source>
        <translation>请记录更久</translation>
    </message>
    <message>
        <source>parts of the record do not go round</source>
        <translation>部分记录没有转满一圈</translation>
    </message>
    <message>
        <source>a plateau stands still or turns against its current</source>
        <translation>某个平台静止或逆电流方向转动</translation>
    </message>
    <message>
        <source>leave plateaus that stop out of the fit</source>
        <translation>请将停住的平台排除在拟合之外</translation>
    </message>
    <message>
        <source>no usable plateau</source>
        <translation>没有可用的平台</translation>
    </message>
    <message>
        <source>use currents above the breakaway current</source>
        <translation>请使用大于起动电流的电流</translation>
    </message>
    <message>
        <source>too few plateaus to know their scatter</source>
        <translation>平台太少，无法得知其离散程度</translation>
    </message>
    <message>
        <source>visit at least three currents in one direction, four in both</source>
        <translation>单向至少测三个电流，双向至少四个</translation>
    </message>
    <message>
        <source>the speed does not grow with the current</source>
        <translation>转速没有随电流增大</translation>
    </message>
    <message>
        <source>check the sign of the current and that the plateaus are steady</source>
        <translation>请检查电流的符号以及平台是否稳态</translation>
    </message>
    <message>
        <source>not identifiable</source>
        <translation>不可辨识</translation>
    </message>
    <message>
        <source>a value of the fit is not a finite number</source>
        <translation>拟合中的某个值不是有限数</translation>
    </message>
    <message>
        <source>look for gaps or faults in the recording</source>
        <translation>请查找记录中的缺口或错误</translation>
    </message>
    <message>
        <source>{} usable points cannot decide {} coefficients</source>
        <translation>{} 个可用点无法确定 {} 个系数</translation>
    </message>
    <message>
        <source>measure more points</source>
        <translation>请测量更多的点</translation>
    </message>
    <message>
        <source>the points do not tell the coefficients apart</source>
        <translation>这些点无法区分各系数</translation>
    </message>
    <message>
        <source>visit more different currents, speeds or directions</source>
        <translation>请测量更多不同的电流、转速或方向</translation>
    </message>
    <message>
        <source>the recording holds no stretch of motion under constant current</source>
        <translation>记录中没有恒定电流下的运动段</translation>
    </message>
    <message>
        <source>hold each current for a second or more, well above the breakaway current</source>
        <translation>每个电流请保持一秒以上，并明显高于起动电流</translation>
    </message>
    <message>
        <source>a stretch of motion has too few samples</source>
        <translation>有一段运动的样本太少</translation>
    </message>
    <message>
        <source>record faster</source>
        <translation>请提高采样率</translation>
    </message>
    <message>
        <source>an angle of the recording is not a number</source>
        <translation>记录中有一个角度不是数字</translation>
    </message>
    <message>
        <source>cut the damaged rows out</source>
        <translation>请去掉损坏的行</translation>
    </message>
    <message>
        <source>the damping of the motion cannot be decided</source>
        <translation>无法确定运动的阻尼</translation>
    </message>
    <message>
        <source>record run-ups and coast-downs over a wider range of speed</source>
        <translation>请在更宽的转速范围记录升速和自由减速</translation>
    </message>
    <message>
        <source>the segments do not bend: the damping is undecided</source>
        <translation>各段没有弯曲：阻尼无法确定</translation>
    </message>
    <message>
        <source>record run-ups and coast-downs, not only steady motion</source>
        <translation>请记录升速和自由减速，而不仅是稳态运动</translation>
    </message>
    <message>
        <source>the columns of the recording differ in length</source>
        <translation>记录各列的长度不同</translation>
    </message>
    <message>
        <source>the recording holds a value that is not a number</source>
        <translation>记录中有一个值不是数字</translation>
    </message>
    <message>
        <source>the time of the recording does not increase</source>
        <translation>记录的时间没有递增</translation>
    </message>
    <message>
        <source>sort the rows and remove doubles</source>
        <translation>请对各行排序并去掉重复</translation>
    </message>
    <message>
        <source>a plateau has fewer than three samples</source>
        <translation>某个平台少于三个样本</translation>
    </message>
    <message>
        <source>dwell longer</source>
        <translation>请停留更久</translation>
    </message>
    <message>
        <source>a sample of a plateau is not a finite number</source>
        <translation>平台的某个样本不是有限数</translation>
    </message>
    <message>
        <source>look for faults in the recording</source>
        <translation>请查找记录中的错误</translation>
    </message>
    <message>
        <source>a plateau is shorter than two windows of the steadiness test</source>
        <translation>某个平台短于稳态检验的两个窗口</translation>
    </message>
    <message>
        <source>the fit hangs on single points</source>
        <translation>拟合取决于个别点</translation>
    </message>
    <message>
        <source>a record has too few samples</source>
        <translation>某段记录的样本太少</translation>
    </message>
    <message>
        <source>record faster or longer</source>
        <translation>请提高采样率或记录更久</translation>
    </message>
    <message>
        <source>no run-up and no coast-down</source>
        <translation>没有升速也没有自由减速</translation>
    </message>
    <message>
        <source>record some</source>
        <translation>请记录一些</translation>
    </message>
    <message>
        <source>an angle is not a number</source>
        <translation>有一个角度不是数字</translation>
    </message>
    <message>
        <source>the records do not tell torque, friction and damping apart</source>
        <translation>这些记录无法区分转矩、摩擦和阻尼</translation>
    </message>
    <message>
        <source>add a coast-down or a run-up at a second current</source>
        <translation>请增加一次自由减速或以第二个电流升速</translation>
    </message>
    <message>
        <source>the pre-warp frequency of {} rad/s is not between 0 and the Nyquist frequency of {} rad/s</source>
        <translation>预畸变频率 {} rad/s 不在 0 和奈奎斯特频率 {} rad/s 之间</translation>
    </message>
    <message>
        <source>the system is already sampled</source>
        <translation>系统已离散化</translation>
    </message>
    <message>
        <source>the bilinear rule has no solution: a pole lies at 2/T</source>
        <translation>双线性法无解：有极点位于 2/T</translation>
    </message>
    <message>
        <source>choose a shorter period</source>
        <translation>请选择更短的周期</translation>
    </message>
    <message>
        <source>the transfer function is already sampled</source>
        <translation>传递函数已离散化</translation>
    </message>
    <message>
        <source>{} rad/s lies outside the frequency range of the system</source>
        <translation>{} rad/s 超出系统的频率范围</translation>
    </message>
    <message>
        <source>a step response of {} s in steps of {} s is not possible</source>
        <translation>{} s、步长 {} s 的阶跃响应不可行</translation>
    </message>
    <message>
        <source>state space matrices do not fit: A {}x{}, B {}x{}, C {}x{}, D {}x{}</source>
        <translation>状态空间矩阵不匹配：A {}x{}、B {}x{}、C {}x{}、D {}x{}</translation>
    </message>
    <message>
        <source>a state space matrix holds a value that is not finite</source>
        <translation>状态空间矩阵含有非有限值</translation>
    </message>
    <message>
        <source>there is no path from input {} to output {}</source>
        <translation>从输入 {} 到输出 {} 没有通路</translation>
    </message>
    <message>
        <source>the sample period is not a finite number</source>
        <translation>采样周期不是有限数</translation>
    </message>
    <message>
        <source>a sample period of {} s is not possible</source>
        <translation>{} s 的采样周期不可行</translation>
    </message>
    <message>
        <source>give a positive period in seconds</source>
        <translation>请给出以秒为单位的正周期</translation>
    </message>
    <message>
        <source>sampled at {} s</source>
        <translation>以 {} s 采样</translation>
    </message>
    <message>
        <source>a system that is {} cannot be combined with one that is {}</source>
        <translation>{} 的系统不能与 {} 的系统组合</translation>
    </message>
    <message>
        <source>discretize one of them first</source>
        <translation>请先将其中之一离散化</translation>
    </message>
    <message>
        <source>a coefficient of the transfer function is not a finite number</source>
        <translation>传递函数的某个系数不是有限数</translation>
    </message>
    <message>
        <source>the denominator of the transfer function is zero</source>
        <translation>传递函数的分母为零</translation>
    </message>
    <message>
        <source>the transfer function has more zeros than poles</source>
        <translation>传递函数的零点多于极点</translation>
    </message>
    <message>
        <source>add the filter or the actuator that every real system has</source>
        <translation>请加上任何实际系统都有的滤波器或执行器</translation>
    </message>
    <message>
        <source>one of the two systems needs a delay</source>
        <translation>两个系统之一需要时延</translation>
    </message>
    <message>
        <source>period or duration of the excitation is not a finite number</source>
        <translation>激励的周期或持续时间不是有限数</translation>
    </message>
    <message>
        <source>an excitation of {} s in steps of {} s is not possible</source>
        <translation>{} s、步长 {} s 的激励不可行</translation>
    </message>
    <message>
        <source>a frequency of the excitation is not a finite number</source>
        <translation>激励的某个频率不是有限数</translation>
    </message>
    <message>
        <source>{} to {} Hz does not lie between 0 and the Nyquist frequency of {} Hz</source>
        <translation>{} 到 {} Hz 不在 0 和奈奎斯特频率 {} Hz 之间</translation>
    </message>
    <message>
        <source>{} to {} Hz does not hold {} lines {} Hz apart</source>
        <translation>{} 到 {} Hz 容不下 {} 条间隔 {} Hz 的谱线</translation>
    </message>
    <message>
        <source>excite longer, widen the band or ask for fewer lines</source>
        <translation>请延长激励、加宽频带或减少谱线</translation>
    </message>
    <message>
        <source>a binary sequence of {} stages held for {} samples is not possible</source>
        <translation>{} 级、每级保持 {} 个样本的二进制序列不可行</translation>
    </message>
    <message>
        <source>2 to 16 stages, 1 to 10000 samples</source>
        <translation>2 到 16 级，1 到 10000 个样本</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is of no format that can be read</source>
        <translation>“{}”的格式无法读取</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is of no format that can be written</source>
        <translation>“{}”的格式无法写入</translation>
    </message>
    <message>
        <source>the recording has no signal &apos;{}&apos;</source>
        <translation>记录中没有信号“{}”</translation>
    </message>
    <message>
        <source>it has {}</source>
        <translation>它有 {}</translation>
    </message>
    <message>
        <source>the interval needs numbers</source>
        <translation>区间需要数字</translation>
    </message>
    <message>
        <source>give seconds, e.g. --from 1.5</source>
        <translation>请给出秒数，例如 --from 1.5</translation>
    </message>
    <message>
        <source>the recording has no rows in this interval</source>
        <translation>记录在此区间内没有数据行</translation>
    </message>
    <message>
        <source>it has no rows at all</source>
        <translation>它没有任何数据行</translation>
    </message>
    <message>
        <source>it reaches from {} s to {} s</source>
        <translation>其范围为 {} s 到 {} s</translation>
    </message>
    <message>
        <source>{} {} and outside {} to {} {}</source>
        <translation>{} {}，超出 {} 到 {} {}</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>不是数字</translation>
    </message>
    <message>
        <source>stopped from here: {} was {} at {} s</source>
        <translation>由本机停止：{} 为 {}，时刻 {} s</translation>
    </message>
    <message>
        <source>find the cause, then clear the stop before arming again</source>
        <translation>请找出原因，再解除停止，然后重新使能</translation>
    </message>
    <message>
        <source>a recording begins with the line time_s,SIGNAL_UNIT,...</source>
        <translation>记录以 time_s,SIGNAL_UNIT,... 这一行开头</translation>
    </message>
    <message>
        <source>the first column is not time_s</source>
        <translation>第一列不是 time_s</translation>
    </message>
    <message>
        <source>{} columns</source>
        <translation>{} 列</translation>
    </message>
    <message>
        <source>at most {} are read</source>
        <translation>最多读取 {} 个</translation>
    </message>
    <message>
        <source>a column has no name</source>
        <translation>有一列没有名称</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is there twice</source>
        <translation>列“{}”出现两次</translation>
    </message>
    <message>
        <source>{} fields where the header has {}</source>
        <translation>有 {} 个字段，而表头有 {} 个</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged</source>
        <translation>文件可能被截断或已损坏</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a number</source>
        <translation>“{}”不是数字</translation>
    </message>
    <message>
        <source>numbers are written like -1.5e-3, with a point</source>
        <translation>数字写法如 -1.5e-3，使用小数点</translation>
    </message>
    <message>
        <source>the time does not increase</source>
        <translation>时间没有递增</translation>
    </message>
    <message>
        <source>sort the rows by time_s</source>
        <translation>请按 time_s 对各行排序</translation>
    </message>
    <message>
        <source>at most {} are read; cut the file into pieces that each begin with its first line</source>
        <translation>最多读取 {}；请把文件分成几段，每段都以原文件的首行开头</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>a recording begins with the line time_s,...</source>
        <translation>记录以 time_s,... 这一行开头</translation>
    </message>
    <message>
        <source>cannot read &apos;{}&apos;: {}</source>
        <translation>无法读取“{}”：{}</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>请检查路径</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has {} octets</source>
        <translation>“{}”有 {} 字节</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was changed since it was recorded (SHA-256)</source>
        <translation>“{}”在记录之后被更改（SHA-256）</translation>
    </message>
    <message>
        <source>&apos;{}&apos; holds no whole row</source>
        <translation>“{}”中没有完整的数据行</translation>
    </message>
    <message>
        <source>nothing was recorded before the interruption; the file can be removed</source>
        <translation>中断前没有记录任何内容；可删除该文件</translation>
    </message>
    <message>
        <source>recording interrupted</source>
        <translation>记录中断</translation>
    </message>
    <message>
        <source>{}: octet {}: {}</source>
        <translation>{}：第 {} 字节：{}</translation>
    </message>
    <message>
        <source>remove the sidecar to read the data without it</source>
        <translation>删除附属文件即可不依赖它读取数据</translation>
    </message>
    <message>
        <source>{}: &quot;schema&quot; is not &quot;{}&quot;</source>
        <translation>{}：“schema”不是“{}”</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;: {}</source>
        <translation>无法写入“{}”：{}</translation>
    </message>
    <message>
        <source>check that the folder can be written and the disk has room</source>
        <translation>请检查文件夹可写且磁盘有空间</translation>
    </message>
    <message>
        <source>cannot rename &apos;{}&apos; to &apos;{}&apos;: {}</source>
        <translation>无法将“{}”重命名为“{}”：{}</translation>
    </message>
    <message>
        <source>check that the folder can be written</source>
        <translation>请检查文件夹可写</translation>
    </message>
    <message>
        <source>cannot create the folder &apos;{}&apos;</source>
        <translation>无法创建文件夹“{}”</translation>
    </message>
    <message>
        <source>give a folder that can be written</source>
        <translation>请给出可写的文件夹</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a folder</source>
        <translation>“{}”是文件夹</translation>
    </message>
    <message>
        <source>give the name of a file</source>
        <translation>请给出文件名</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is being written by another program</source>
        <translation>“{}”正由其他程序写入</translation>
    </message>
    <message>
        <source>wait for its end or give another name</source>
        <translation>请等待其结束或给出其他名称</translation>
    </message>
    <message>
        <source>a recording cannot be changed, armed or stopped</source>
        <translation>记录不能更改、使能或停止</translation>
    </message>
    <message>
        <source>use a real or simulated device</source>
        <translation>请使用真实或仿真设备</translation>
    </message>
    <message>
        <source>the recording has no parameter &apos;{}&apos;</source>
        <translation>记录中没有参数“{}”</translation>
    </message>
    <message>
        <source>list the names with: halbench describe replay:FILE</source>
        <translation>可用 halbench describe replay:FILE 列出名称</translation>
    </message>
    <message>
        <source>the recording of {} Hz cannot be played at {} Hz</source>
        <translation>{} Hz 的记录不能以 {} Hz 回放</translation>
    </message>
    <message>
        <source>give a rate that divides {} Hz</source>
        <translation>请给出能整除 {} Hz 的采样率</translation>
    </message>
    <message>
        <source>the recording ends at {} s</source>
        <translation>记录在 {} s 处结束</translation>
    </message>
    <message>
        <source>ask for a shorter time</source>
        <translation>请要求较短的时间</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has fewer than two rows</source>
        <translation>“{}”少于两行</translation>
    </message>
    <message>
        <source>give a recording with data</source>
        <translation>请给出含数据的记录</translation>
    </message>
    <message>
        <source>device address &apos;{}&apos;: {} at character {}</source>
        <translation>设备地址“{}”：{}（第 {} 个字符）</translation>
    </message>
    <message>
        <source>the device address has {} characters</source>
        <translation>设备地址有 {} 个字符</translation>
    </message>
    <message>
        <source>at most {} are allowed</source>
        <translation>最多允许 {} 个</translation>
    </message>
    <message>
        <source>the device address has a control character at character {}</source>
        <translation>设备地址第 {} 个字符是控制字符</translation>
    </message>
    <message>
        <source>write it like sim:htm?seed=7</source>
        <translation>写法如 sim:htm?seed=7</translation>
    </message>
    <message>
        <source>a scheme and &apos;:&apos; are missing</source>
        <translation>缺少协议名和“:”</translation>
    </message>
    <message>
        <source>write it like sim:htm, tcp:HOST:PORT or replay:FILE</source>
        <translation>写法如 sim:htm、tcp:HOST:PORT 或 replay:FILE</translation>
    </message>
    <message>
        <source>device address &apos;{}&apos;: unknown scheme &apos;{}&apos;</source>
        <translation>设备地址“{}”：未知的协议“{}”</translation>
    </message>
    <message>
        <source>known are {}</source>
        <translation>已知的有 {}</translation>
    </message>
    <message>
        <source>a key has letters, digits and &apos;_&apos; only</source>
        <translation>键只能含字母、数字和“_”</translation>
    </message>
    <message>
        <source>write options as KEY=VALUE</source>
        <translation>选项写成 KEY=VALUE</translation>
    </message>
    <message>
        <source>a key is missing</source>
        <translation>缺少键</translation>
    </message>
    <message>
        <source>write options as KEY=VALUE, joined by &apos;&amp;&apos;</source>
        <translation>选项写成 KEY=VALUE，用“&amp;”连接</translation>
    </message>
    <message>
        <source>&apos;=&apos; is missing</source>
        <translation>缺少“=”</translation>
    </message>
    <message>
        <source>a value is missing</source>
        <translation>缺少值</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is given twice</source>
        <translation>“{}”给出了两次</translation>
    </message>
    <message>
        <source>give each key once</source>
        <translation>每个键只给出一次</translation>
    </message>
    <message>
        <source>the address is missing</source>
        <translation>缺少地址</translation>
    </message>
    <message>
        <source>write it like sim:htm or tcp:HOST:PORT</source>
        <translation>写法如 sim:htm 或 tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>device &apos;{}&apos;: unknown option &apos;{}&apos;</source>
        <translation>设备“{}”：未知的选项“{}”</translation>
    </message>
    <message>
        <source>must be &quot;{}&quot;</source>
        <translation>必须是“{}”</translation>
    </message>
    <message>
        <source>must name the model</source>
        <translation>必须指明型号</translation>
    </message>
    <message>
        <source>compare with resources/devices/htm.json</source>
        <translation>请与 resources/devices/htm.json 比较</translation>
    </message>
    <message>
        <source>is not a key of a profile</source>
        <translation>不是配置文件的键</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>必须是文本</translation>
    </message>
    <message>
        <source>must be a number</source>
        <translation>必须是数字</translation>
    </message>
    <message>
        <source>must be a list of texts</source>
        <translation>必须是文本列表</translation>
    </message>
    <message>
        <source>must be an object</source>
        <translation>必须是对象</translation>
    </message>
    <message>
        <source>correct the JSON</source>
        <translation>请改正该 JSON</translation>
    </message>
    <message>
        <source>{}: a profile is one JSON object</source>
        <translation>{}：配置文件是一个 JSON 对象</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>必须为 true 或 false</translation>
    </message>
    <message>
        <source>is not a key of an axis</source>
        <translation>不是轴的键</translation>
    </message>
    <message>
        <source>must be a positive number</source>
        <translation>必须为正数</translation>
    </message>
    <message>
        <source>must be &quot;rad&quot; or &quot;m&quot;</source>
        <translation>必须为 &quot;rad&quot; 或 &quot;m&quot;</translation>
    </message>
    <message>
        <source>must be a unit of the program, e.g. &quot;N&quot;</source>
        <translation>必须是本程序的单位，例如 &quot;N&quot;</translation>
    </message>
    <message>
        <source>must be a role of this profile</source>
        <translation>必须是此配置文件中的角色</translation>
    </message>
    <message>
        <source>must be a list of axes</source>
        <translation>必须是轴的列表</translation>
    </message>
    <message>
        <source>must differ from the other axes</source>
        <translation>必须与其他轴不同</translation>
    </message>
    <message>
        <source>the device was unplugged</source>
        <translation>设备已被拔出</translation>
    </message>
    <message>
        <source>Connect it and open it again.</source>
        <translation>请连接后重新打开。</translation>
    </message>
    <message>
        <source>the loopback to the simulated board is closed</source>
        <translation>与仿真控制板的连接已关闭</translation>
    </message>
    <message>
        <source>Open the device again.</source>
        <translation>请重新打开设备。</translation>
    </message>
    <message>
        <source>True rotor angle, known to the simulation only</source>
        <translation>转子的真实角度，仅仿真可知</translation>
    </message>
    <message>
        <source>True rotor speed, known to the simulation only</source>
        <translation>转子的真实转速，仅仿真可知</translation>
    </message>
    <message>
        <source>there is no simulator &apos;sim:{}&apos;</source>
        <translation>没有仿真器“sim:{}”</translation>
    </message>
    <message>
        <source>Built simulators: {}.</source>
        <translation>已包含的仿真器：{}。</translation>
    </message>
    <message>
        <source>{}={} is out of range</source>
        <translation>{}={} 超出范围</translation>
    </message>
    <message>
        <source>{}={} is not a number</source>
        <translation>{}={} 不是数字</translation>
    </message>
    <message>
        <source>Write numbers like 2e-3. {}</source>
        <translation>数字写法如 2e-3。{}</translation>
    </message>
    <message>
        <source>seed={} is not a whole number</source>
        <translation>seed={} 不是整数</translation>
    </message>
    <message>
        <source>A seed is a whole number from 0 to 18446744073709551615. Known keys: {}.</source>
        <translation>种子是 0 到 18446744073709551615 的整数。已知的键：{}。</translation>
    </message>
    <message>
        <source>{}={} is unknown</source>
        <translation>{}={} 未知</translation>
    </message>
    <message>
        <source>Allowed: {}={} and {}={}. {}</source>
        <translation>允许：{}={} 和 {}={}。{}</translation>
    </message>
    <message>
        <source>{} has no override &apos;{}&apos;</source>
        <translation>{} 没有设置项“{}”</translation>
    </message>
    <message>
        <source>a message of {} octets was announced, 1 to {} are possible</source>
        <translation>通告了 {} 字节的消息，可能的范围是 1 到 {}</translation>
    </message>
    <message>
        <source>the other side does not speak this protocol</source>
        <translation>对方不使用此协议</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not HOST:PORT</source>
        <translation>“{}”不是 HOST:PORT 的形式</translation>
    </message>
    <message>
        <source>write it like 127.0.0.1:5555 or [::1]:5555, port 0 to 65535</source>
        <translation>写法如 127.0.0.1:5555 或 [::1]:5555，端口 0 到 65535</translation>
    </message>
    <message>
        <source>check that the board is on and the address is right</source>
        <translation>请检查控制板已通电且地址正确</translation>
    </message>
    <message>
        <source>cannot listen on {}: {}</source>
        <translation>无法监听 {}：{}</translation>
    </message>
    <message>
        <source>give an address of this machine and a free port, or port 0</source>
        <translation>请给出本机的地址和空闲端口，或端口 0</translation>
    </message>
    <message>
        <source>check that the board is on and no other program uses it, then connect again</source>
        <translation>请检查控制板已通电且没有被其他程序使用，然后重新连接</translation>
    </message>
    <message>
        <source>the board takes no more commands</source>
        <translation>控制板不再接受命令</translation>
    </message>
    <message>
        <source>the connection is closed</source>
        <translation>连接已关闭</translation>
    </message>
    <message>
        <source>the board closed the connection (another program may have taken it)</source>
        <translation>控制板关闭了连接（可能已被其他程序占用）</translation>
    </message>
    <message>
        <source>{} octets are more than the allowed {}</source>
        <translation>{} 字节超过允许的 {} 字节</translation>
    </message>
    <message>
        <source>the board&apos;s description, octet {}: {}</source>
        <translation>控制板的描述，第 {} 字节：{}</translation>
    </message>
    <message>
        <source>update the board&apos;s firmware or report the description to its maker</source>
        <translation>请更新控制板固件，或将此描述报告给制造商</translation>
    </message>
    <message>
        <source>a comment does not end</source>
        <translation>注释没有结束</translation>
    </message>
    <message>
        <source>a text is too long</source>
        <translation>文本太长</translation>
    </message>
    <message>
        <source>a text does not end</source>
        <translation>文本没有结束</translation>
    </message>
    <message>
        <source>a word is too long</source>
        <translation>单词太长</translation>
    </message>
    <message>
        <source>the name of a block is missing</source>
        <translation>缺少块的名称</translation>
    </message>
    <message>
        <source>{} is missing</source>
        <translation>缺少 {}</translation>
    </message>
    <message>
        <source>{} is missing (a text in quotes)</source>
        <translation>缺少 {}（引号中的文本）</translation>
    </message>
    <message>
        <source>{}: &apos;{}&apos; is not a number</source>
        <translation>{}：“{}”不是数字</translation>
    </message>
    <message>
        <source>{}: {} is not a whole number from 0 to {}</source>
        <translation>{}：{} 不是 0 到 {} 的整数</translation>
    </message>
    <message>
        <source>block {} does not end</source>
        <translation>块 {} 没有结束</translation>
    </message>
    <message>
        <source>blocks are nested deeper than {}</source>
        <translation>块的嵌套超过 {} 层</translation>
    </message>
    <message>
        <source>/end {} where /end {} is due</source>
        <translation>应为 /end {1}，却是 /end {0}</translation>
    </message>
    <message>
        <source>its type &apos;{}&apos; is not known</source>
        <translation>其类型“{}”未知</translation>
    </message>
    <message>
        <source>its conversion &apos;{}&apos; is {}</source>
        <translation>其换算“{}”{}</translation>
    </message>
    <message>
        <source>not of a supported kind</source>
        <translation>不是支持的种类</translation>
    </message>
    <message>
        <source>its lower limit is above the upper one; the type&apos;s limits are used</source>
        <translation>其下限高于上限；改用类型的限值</translation>
    </message>
    <message>
        <source>&apos;{}&apos; (octet {} of the description): {}</source>
        <translation>“{}”（描述的第 {} 字节）：{}</translation>
    </message>
    <message>
        <source>this board cannot capture by itself</source>
        <translation>此控制板不能自行捕获</translation>
    </message>
    <message>
        <source>record a stream instead</source>
        <translation>请改为记录数据流</translation>
    </message>
    <message>
        <source>signal {} has {} octets; the board samples values of up to {} octets in steps of {}</source>
        <translation>信号 {} 有 {} 字节；控制板采样的值最多 {} 字节，步长 {}</translation>
    </message>
    <message>
        <source>leave this signal out</source>
        <translation>请去掉此信号</translation>
    </message>
    <message>
        <source>{} signals do not fit into one sample of this board</source>
        <translation>{} 个信号无法放入此控制板的一次采样</translation>
    </message>
    <message>
        <source>ask for fewer signals</source>
        <translation>请减少信号</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;</source>
        <translation>无法写入“{}”</translation>
    </message>
    <message>
        <source>make room or make the folder writable</source>
        <translation>请腾出空间或使文件夹可写</translation>
    </message>
    <message>
        <source>cannot rename &apos;{}&apos;</source>
        <translation>无法重命名“{}”</translation>
    </message>
    <message>
        <source>make the folder writable</source>
        <translation>请使文件夹可写</translation>
    </message>
    <message>
        <source>the command queue was cleared</source>
        <translation>命令队列已清空</translation>
    </message>
    <message>
        <source>the board is busy</source>
        <translation>控制板忙</translation>
    </message>
    <message>
        <source>not possible while samples are streaming</source>
        <translation>数据流传输期间无法进行</translation>
    </message>
    <message>
        <source>not possible while the board is being programmed</source>
        <translation>控制板编程期间无法进行</translation>
    </message>
    <message>
        <source>the board does not know the command</source>
        <translation>控制板不认识该命令</translation>
    </message>
    <message>
        <source>the board found the command malformed</source>
        <translation>控制板认为命令格式错误</translation>
    </message>
    <message>
        <source>the value is out of range</source>
        <translation>数值超出范围</translation>
    </message>
    <message>
        <source>the memory is write protected</source>
        <translation>存储器有写保护</translation>
    </message>
    <message>
        <source>access is denied</source>
        <translation>访问被拒绝</translation>
    </message>
    <message>
        <source>access is locked</source>
        <translation>访问已锁定</translation>
    </message>
    <message>
        <source>the page does not exist</source>
        <translation>页不存在</translation>
    </message>
    <message>
        <source>the mode does not exist</source>
        <translation>模式不存在</translation>
    </message>
    <message>
        <source>the segment does not exist</source>
        <translation>段不存在</translation>
    </message>
    <message>
        <source>the commands came in the wrong order</source>
        <translation>命令顺序错误</translation>
    </message>
    <message>
        <source>the list of samples is not valid</source>
        <translation>采样列表无效</translation>
    </message>
    <message>
        <source>the board has no memory left</source>
        <translation>控制板内存不足</translation>
    </message>
    <message>
        <source>the board refuses</source>
        <translation>控制板拒绝</translation>
    </message>
    <message>
        <source>verification failed</source>
        <translation>校验失败</translation>
    </message>
    <message>
        <source>the resource is not accessible now</source>
        <translation>资源当前不可访问</translation>
    </message>
    <message>
        <source>the answer to {} has {} octets ({}), {} are needed</source>
        <translation>对 {} 的应答有 {} 字节（{}），需要 {} 字节</translation>
    </message>
    <message>
        <source>update the board&apos;s firmware or check the line</source>
        <translation>请更新控制板固件或检查线路</translation>
    </message>
    <message>
        <source>command {}</source>
        <translation>命令 {}</translation>
    </message>
    <message>
        <source>unknown error {}</source>
        <translation>未知错误 {}</translation>
    </message>
    <message>
        <source>the board counts addresses in words, not octets</source>
        <translation>控制板按字而不是按字节计地址</translation>
    </message>
    <message>
        <source>only octet granularity is supported</source>
        <translation>只支持按字节寻址</translation>
    </message>
    <message>
        <source>the board announces packets of {} and {} octets, at least 8 are needed</source>
        <translation>控制板通告的数据包为 {} 和 {} 字节，至少需要 8 字节</translation>
    </message>
    <message>
        <source>this is not a board of a protocol known here</source>
        <translation>这不是使用已知协议的控制板</translation>
    </message>
    <message>
        <source>the answer to GET_ID promises {} octets and holds {}</source>
        <translation>对 GET_ID 的应答声明 {} 字节，实有 {} 字节</translation>
    </message>
    <message>
        <source>the sampling resolution makes no sense ({})</source>
        <translation>采样分辨率没有意义（{}）</translation>
    </message>
    <message>
        <source>update the board&apos;s firmware</source>
        <translation>请更新控制板固件</translation>
    </message>
    <message>
        <source>time unit {} does not exist</source>
        <translation>时间单位 {} 不存在</translation>
    </message>
    <message>
        <source>the board runs on page {} of a segment of {} octets</source>
        <translation>控制板运行在第 {} 页，段长 {} 字节</translation>
    </message>
    <message>
        <source>only pages 0 and 1 are known here; update the board&apos;s firmware</source>
        <translation>只支持第 0 页和第 1 页；请更新控制板固件</translation>
    </message>
    <message>
        <source>the board does not free its idle parameter page</source>
        <translation>控制板没有释放其空闲参数页</translation>
    </message>
    <message>
        <source>check that the board&apos;s control loop runs; the old values stay</source>
        <translation>请检查控制板的控制回路是否运行；原值保持不变</translation>
    </message>
    <message>
        <source>the board did not take the new set of parameters</source>
        <translation>控制板没有接受新的参数组</translation>
    </message>
    <message>
        <source>check the board&apos;s state; the old values stay</source>
        <translation>请检查控制板的状态；原值保持不变</translation>
    </message>
    <message>
        <source>the board keeps other values than those sent</source>
        <translation>控制板保留的值与发送的不同</translation>
    </message>
    <message>
        <source>the old values stay; check the limits of the board</source>
        <translation>原值保持不变；请检查控制板的限值</translation>
    </message>
    <message>
        <source>the nearest possible rates are {} Hz and {} Hz</source>
        <translation>最接近的可用采样率为 {} Hz 和 {} Hz</translation>
    </message>
    <message>
        <source>the nearest possible rate is {} Hz</source>
        <translation>最接近的可用采样率为 {} Hz</translation>
    </message>
    <message>
        <source>these signals have no periodic event</source>
        <translation>这些信号没有周期事件</translation>
    </message>
    <message>
        <source>the board samples &apos;{}&apos; ({}) at another event than &apos;{}&apos; ({})</source>
        <translation>控制板对“{}”（{}）和“{}”（{}）使用不同的采样事件</translation>
    </message>
    <message>
        <source>stream signals of one event together, the others in a stream of their own</source>
        <translation>请把同一事件的信号放在一个数据流中，其他信号另用数据流</translation>
    </message>
    <message>
        <source>the device has no signal &apos;{}&apos;</source>
        <translation>设备没有信号“{}”</translation>
    </message>
    <message>
        <source>list the signals with: halbench describe DEVICE</source>
        <translation>可用 halbench describe DEVICE 列出信号</translation>
    </message>
    <message>
        <source>a stream needs at least one signal</source>
        <translation>数据流至少需要一个信号</translation>
    </message>
    <message>
        <source>name a signal</source>
        <translation>请指定一个信号</translation>
    </message>
    <message>
        <source>the device cannot send these signals at {} Hz</source>
        <translation>设备无法以 {} Hz 发送这些信号</translation>
    </message>
    <message>
        <source>the board&apos;s parameters are locked</source>
        <translation>控制板的参数已锁定</translation>
    </message>
    <message>
        <source>description of &apos;{}&apos; taken from the cache</source>
        <translation>“{}”的描述取自缓存</translation>
    </message>
    <message>
        <source>description read from the board, {} octets</source>
        <translation>已从控制板读取描述，{} 字节</translation>
    </message>
    <message>
        <source>the description is not kept: {}</source>
        <translation>未保存描述：{}</translation>
    </message>
    <message>
        <source>the board could not send all samples in time</source>
        <translation>控制板未能及时发送所有样本</translation>
    </message>
    <message>
        <source>the board stopped</source>
        <translation>控制板已停止</translation>
    </message>
    <message>
        <source>the board stopped the actuator: {}</source>
        <translation>控制板停止了执行器：{}</translation>
    </message>
    <message>
        <source>this board has no &apos;{}&apos; and cannot be armed from here</source>
        <translation>此控制板没有“{}”，无法在此使能</translation>
    </message>
    <message>
        <source>use the maker&apos;s own program to arm it</source>
        <translation>请用制造商的程序使能</translation>
    </message>
    <message>
        <source>the board cannot be armed: {}</source>
        <translation>控制板无法使能：{}</translation>
    </message>
    <message>
        <source>find the cause, then clear the stop</source>
        <translation>请找出原因，然后解除停止</translation>
    </message>
    <message>
        <source>the board does not {}</source>
        <translation>控制板没有执行“{}”</translation>
    </message>
    <message>
        <source>use the stop at the actuator and check the board</source>
        <translation>请使用执行器处的急停，并检查控制板</translation>
    </message>
    <message>
        <source>the board keeps its stop: {}</source>
        <translation>控制板保持停止：{}</translation>
    </message>
    <message>
        <source>remove the cause first</source>
        <translation>请先排除原因</translation>
    </message>
    <message>
        <source>this device cannot stream signals</source>
        <translation>此设备不能发送信号数据流</translation>
    </message>
    <message>
        <source>read single values instead</source>
        <translation>请改为读取单个值</translation>
    </message>
    <message>
        <source>link: {} packets, {} lost, {} damaged, {} commands repeated, round trip {} ms, at worst {} ms</source>
        <translation>链路：{} 个数据包，丢失 {}，损坏 {}，重发命令 {}，往返时间 {} ms，最长 {} ms</translation>
    </message>
    <message>
        <source>, the board&apos;s clock gains {} +- {} ppm</source>
        <translation>，控制板时钟快 {} ± {} ppm</translation>
    </message>
    <message>
        <source>{} sends no samples any more</source>
        <translation>{} 不再发送样本</translation>
    </message>
    <message>
        <source>the board or another program ended the stream; connect again</source>
        <translation>控制板或其他程序结束了数据流；请重新连接</translation>
    </message>
    <message>
        <source>list the names with: halbench describe DEVICE</source>
        <translation>可用 halbench describe DEVICE 列出名称</translation>
    </message>
    <message>
        <source>the device has no parameter &apos;{}&apos;</source>
        <translation>设备没有参数“{}”</translation>
    </message>
    <message>
        <source>the board keeps another value of &apos;{}&apos; than the one sent</source>
        <translation>控制板保留的“{}”与发送的值不同</translation>
    </message>
    <message>
        <source>the old values stay; give values inside the board&apos;s limits</source>
        <translation>原值保持不变；请给出控制板限值内的值</translation>
    </message>
    <message>
        <source>this board cannot change a set at once: values change one by one</source>
        <translation>此控制板不能一次更改整组参数：各值逐个更改</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos;: {}</source>
        <translation>参数“{}”：{}</translation>
    </message>
    <message>
        <source>the board keeps &apos;{}&apos; = {} {} instead of {}</source>
        <translation>控制板保留“{}”= {} {}，而不是 {}</translation>
    </message>
    <message>
        <source>check the board&apos;s state and limits</source>
        <translation>请检查控制板的状态和限值</translation>
    </message>
    <message>
        <source>check cable, power and address, then connect again</source>
        <translation>请检查电缆、电源和地址，然后重新连接</translation>
    </message>
    <message>
        <source>{} does not answer {}</source>
        <translation>{} 对 {} 没有应答</translation>
    </message>
    <message>
        <source>the board refused {}: {}</source>
        <translation>控制板拒绝了 {}：{}</translation>
    </message>
    <message>
        <source>check the value and the board&apos;s state</source>
        <translation>请检查该值和控制板的状态</translation>
    </message>
    <message>
        <source>{} ended the session (its watchdog ran out or another program connected)</source>
        <translation>{} 结束了会话（看门狗超时或其他程序已连接）</translation>
    </message>
    <message>
        <source>make sure that no other program uses the board, then connect again</source>
        <translation>请确认没有其他程序使用该控制板，然后重新连接</translation>
    </message>
    <message>
        <source>{} does not answer any more</source>
        <translation>{} 不再应答</translation>
    </message>
    <message>
        <source>the board did not store its parameters within {} s</source>
        <translation>控制板在 {} s 内没有保存参数</translation>
    </message>
    <message>
        <source>try again, then read the values back</source>
        <translation>请重试，然后读回数值</translation>
    </message>
    <message>
        <source>the board holds no description of itself</source>
        <translation>控制板不含自身的描述</translation>
    </message>
    <message>
        <source>the board&apos;s description has {} octets</source>
        <translation>控制板的描述有 {} 字节</translation>
    </message>
    <message>
        <source>the board needed more than {} s for its description</source>
        <translation>控制板传送描述用时超过 {} s</translation>
    </message>
    <message>
        <source>use a faster connection</source>
        <translation>请使用更快的连接</translation>
    </message>
    <message>
        <source>Every amplifier part must be positive and finite.</source>
        <translation>放大器的每个元件值都必须为有限正数。</translation>
    </message>
    <message>
        <source>Check resistors, capacitors and the coil&apos;s resistance and inductance.</source>
        <translation>请检查电阻、电容以及线圈的电阻和电感。</translation>
    </message>
    <message>
        <source>The decoded angle jumped by more than 90 degrees between two samples.</source>
        <translation>解码的角度在两个样本之间跳变超过 90 度。</translation>
    </message>
    <message>
        <source>The direction of such a jump is a guess; check the sensors or turn slower.</source>
        <translation>这种跳变的方向只能猜测；请检查传感器或降低转速。</translation>
    </message>
    <message>
        <source>Allowed: {} to {}{}{}{}. Known keys: {}.</source>
        <translation>允许：{} 到 {}{}{}{}。已知的键：{}。</translation>
    </message>
    <message>
        <source>{} is not a finite number</source>
        <translation>{} 不是有限数</translation>
    </message>
    <message>
        <source>{} = {} is out of range</source>
        <translation>{} = {} 超出范围</translation>
    </message>
    <message>
        <source>the planar positioner has no parameter &apos;{}&apos;</source>
        <translation>平面定位台没有参数“{}”</translation>
    </message>
    <message>
        <source>a coil of {} mm width leaves no window within half a pitch of {} mm</source>
        <translation>宽 {} mm 的线圈在 {} mm 的半个磁极周期内没有留下窗口</translation>
    </message>
    <message>
        <source>Make coil_width_mm smaller than {} mm.</source>
        <translation>请将 coil_width_mm 设为小于 {} mm。</translation>
    </message>
    <message>
        <source>the start pose lies beyond the stops at {} mm and {} mrad</source>
        <translation>起始位姿超出了 {} mm 和 {} mrad 处的限位</translation>
    </message>
    <message>
        <source>Keep x0_mm and y0_mm within {} mm, phi0_mrad within {} mrad.</source>
        <translation>请使 x0_mm 和 y0_mm 不超过 {} mm，phi0_mrad 不超过 {} mrad。</translation>
    </message>
    <message>
        <source>the motor has no parameter &apos;{}&apos;</source>
        <translation>电机没有参数“{}”</translation>
    </message>
    <message>
        <source>Known keys: {}.</source>
        <translation>已知的键：{}。</translation>
    </message>
    <message>
        <source>A Hall sensor setting is not a finite number.</source>
        <translation>某个霍尔传感器设置不是有限数。</translation>
    </message>
    <message>
        <source>A Hall sensor needs a positive sensitivity, noise of at least zero and a lower clip voltage below the upper one.</source>
        <translation>霍尔传感器需要正的灵敏度、不小于零的噪声，且下限幅电压低于上限幅电压。</translation>
    </message>
    <message>
        <source>A field harmonic needs an order of at least 1 and finite amplitudes.</source>
        <translation>磁场谐波的阶次至少为 1，幅值必须有限。</translation>
    </message>
    <message>
        <source>A constant belongs into the offset.</source>
        <translation>常数应归入偏置。</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>a date or time</source>
        <translation>日期或时间</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>{}: is not PATH=VALUE</source>
        <translation>{}：不是“路径=值”的形式</translation>
    </message>
    <message>
        <source>write step.sweep.given.J=6e-4</source>
        <translation>请写成 step.sweep.given.J=6e-4</translation>
    </message>
    <message>
        <source>{}: there is no such step</source>
        <translation>{}：没有这个步骤</translation>
    </message>
    <message>
        <source>write step.NAME.KEY=VALUE with the name of a step of the file</source>
        <translation>请写成 step.NAME.KEY=VALUE，NAME 为文件中某个步骤的名称</translation>
    </message>
    <message>
        <source>{}:{}:{}: not valid JSON: {}</source>
        <translation>{}:{}:{}：不是有效的 JSON：{}</translation>
    </message>
    <message>
        <source>correct the file or write it again with --out</source>
        <translation>请改正该文件，或用 --out 重新写出</translation>
    </message>
    <message>
        <source>the result holds a value that is not a finite number at &apos;{}&apos;</source>
        <translation>结果在“{}”处含有非有限数</translation>
    </message>
    <message>
        <source>report this with the command line that led to it</source>
        <translation>请连同所用的命令一起报告此问题</translation>
    </message>
    <message>
        <source>is &quot;{}&quot;, this version reads &quot;{}&quot;</source>
        <translation>为“{}”，此版本读取“{}”</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>is &quot;{}&quot;, not &quot;{}&quot;</source>
        <translation>为“{}”，而不是“{}”</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>必须是有限数</translation>
    </message>
    <message>
        <source>must be a whole number from 0 to {}</source>
        <translation>必须是 0 到 {} 的整数</translation>
    </message>
    <message>
        <source>write the file again with &apos;halbench {} --out&apos;</source>
        <translation>请用“halbench {} --out”重新写出该文件</translation>
    </message>
    <message>
        <source>must be a list of lists of numbers</source>
        <translation>必须是数字列表的列表</translation>
    </message>
    <message>
        <source>must hold finite numbers</source>
        <translation>必须只含有限数</translation>
    </message>
    <message>
        <source>needs as many rows as names</source>
        <translation>行数必须与名称数相同</translation>
    </message>
    <message>
        <source>must be square</source>
        <translation>必须是方阵</translation>
    </message>
    <message>
        <source>{}: this estimate was refused</source>
        <translation>{}：此估计已被拒绝</translation>
    </message>
    <message>
        <source>see its findings, then identify again</source>
        <translation>请查看其评估说明，然后重新辨识</translation>
    </message>
    <message>
        <source>needs a value and the two ends of its interval</source>
        <translation>需要一个值及其区间的两端</translation>
    </message>
    <message>
        <source>{}: cannot write: {}</source>
        <translation>{}：无法写入：{}</translation>
    </message>
    <message>
        <source>free space on the disk</source>
        <translation>请释放磁盘空间</translation>
    </message>
    <message>
        <source>choose another path or change its permissions</source>
        <translation>请选择其他路径或更改其权限</translation>
    </message>
    <message>
        <source>{}: is a folder</source>
        <translation>{}：是文件夹</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>请指定一个文件</translation>
    </message>
    <message>
        <source>{}: cannot read: {}</source>
        <translation>{}：无法读取：{}</translation>
    </message>
    <message>
        <source>{}: larger than 256 MB</source>
        <translation>{}：大于 256 MB</translation>
    </message>
    <message>
        <source>give a smaller file</source>
        <translation>请提供较小的文件</translation>
    </message>
    <message>
        <source>there is no preset &apos;{}&apos; for a device of model &apos;{}&apos;</source>
        <translation>型号为“{1}”的设备没有预设“{0}”</translation>
    </message>
    <message>
        <source>htm has {}</source>
        <translation>htm 有 {}</translation>
    </message>
    <message>
        <source>compare with resources/presets/htm/published.json</source>
        <translation>请与 resources/presets/htm/published.json 比较</translation>
    </message>
    <message>
        <source>must be &quot;halbench.preset/1&quot;</source>
        <translation>必须是“halbench.preset/1”</translation>
    </message>
    <message>
        <source>must be an object of numbers</source>
        <translation>必须是数字组成的对象</translation>
    </message>
    <message>
        <source>{}:{}:{}: not valid TOML: {}</source>
        <translation>{}:{}:{}：不是有效的 TOML：{}</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a text</source>
        <translation>“{}”必须是文本</translation>
    </message>
    <message>
        <source>&apos;layout&apos; must be a table</source>
        <translation>“layout”必须是表</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a list of tables, [[{}]]</source>
        <translation>“{}”必须是表的列表，[[{}]]</translation>
    </message>
    <message>
        <source>the file is left as it is; open another project or mend this line</source>
        <translation>文件保持原样；请打开其他项目或改正该行</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a [[{}]] has name and document</source>
        <translation>未知的键“{}”；[[{}]] 只有 name 和 document</translation>
    </message>
    <message>
        <source>{}: is a &apos;{}&apos;, made by a newer version</source>
        <translation>{}：是由较新版本生成的“{}”</translation>
    </message>
    <message>
        <source>this version reads {}; the file is left as it is</source>
        <translation>此版本读取 {}；文件保持原样</translation>
    </message>
    <message>
        <source>{}: is not a Halbench project</source>
        <translation>{}：不是 Halbench 项目</translation>
    </message>
    <message>
        <source>a project begins with schema = &quot;{}&quot;</source>
        <translation>项目文件以 schema = &quot;{}&quot; 开头</translation>
    </message>
    <message>
        <source>choose another preset</source>
        <translation>请选择其他预设</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is too large for a preset</source>
        <translation>“{}”太大，不是预设文件</translation>
    </message>
    <message>
        <source>choose a preset file</source>
        <translation>请选择预设文件</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was written by a newer Halbench ({})</source>
        <translation>“{}”由较新的 Halbench 写成（{}）</translation>
    </message>
    <message>
        <source>open it there, or install that version</source>
        <translation>请在那个版本中打开，或安装该版本</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is for a device of model &apos;{}&apos;</source>
        <translation>“{}”适用于型号为“{}”的设备</translation>
    </message>
    <message>
        <source>this device is of model &apos;{}&apos;</source>
        <translation>此设备的型号为“{}”</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be the name of a preset</source>
        <translation>“{}”不能用作预设名称</translation>
    </message>
    <message>
        <source>use letters, digits, spaces, points and hyphens</source>
        <translation>请使用字母、数字、空格、点和连字符</translation>
    </message>
    <message>
        <source>check the folder and the space on the disk</source>
        <translation>请检查文件夹和磁盘空间</translation>
    </message>
    <message>
        <source>choose another folder or name</source>
        <translation>请选择其他文件夹或名称</translation>
    </message>
    <message>
        <source>there is no picture to save</source>
        <translation>没有可保存的图片</translation>
    </message>
    <message>
        <source>K_P = {}, K_I = {}, K_D = {} is no position loop</source>
        <translation>K_P = {}、K_I = {}、K_D = {} 不能构成位置回路</translation>
    </message>
    <message>
        <source>K_P must be positive, K_I and K_D not negative</source>
        <translation>K_P 必须为正，K_I 和 K_D 不能为负</translation>
    </message>
    <message>
        <source>a current limit of {} A is not possible</source>
        <translation>电流限值 {} A 不可行</translation>
    </message>
    <message>
        <source>the stray field of the coils is not described by finite numbers</source>
        <translation>线圈杂散磁场的描述含有非有限数</translation>
    </message>
    <message>
        <source>the sampled loop is unstable: pole radius {}</source>
        <translation>采样回路不稳定：极点半径 {}</translation>
    </message>
    <message>
        <source>only friction and the current limit bound it, and no common factor on these gains makes it stable: change their ratio or the filters, or use method recommended</source>
        <translation>只有摩擦和电流限值约束其运动，任何公共系数都不能使这些增益稳定：请改变它们的比例或滤波器，或使用方法 recommended</translation>
    </message>
    <message>
        <source>only friction and the current limit bound it; below {} times these gains it is stable: lower K_P, or use method recommended</source>
        <translation>只有摩擦和电流限值约束其运动；低于这些增益的 {} 倍时回路稳定：请降低 K_P，或使用方法 recommended</translation>
    </message>
    <message>
        <source>only friction and the current limit bound it; above {} times these gains it is stable: raise them, or use method recommended</source>
        <translation>只有摩擦和电流限值约束其运动；高于这些增益的 {} 倍时回路稳定：请提高增益，或使用方法 recommended</translation>
    </message>
    <message>
        <source>K_P = {} A/rad is {} times the limit of {} A/rad at this sampling and delay</source>
        <translation>K_P = {} A/rad 是在此采样和时延下极限值的 {} 倍（极限 {} A/rad）</translation>
    </message>
    <message>
        <source>the rotor rests and makes small steps at best; large steps end in a limit cycle</source>
        <translation>转子静止时最多只能做小阶跃；大阶跃将陷入极限环</translation>
    </message>
    <message>
        <source>the loop is nearly undamped (zeta = {} at {} rad/s): only friction damps it</source>
        <translation>回路几乎无阻尼（zeta = {}，{} rad/s）：只有摩擦提供阻尼</translation>
    </message>
    <message>
        <source>a PI loop cannot do better on this motor; derivative action can: method recommended</source>
        <translation>PI 回路在此电机上无法更好；微分作用可以：方法 recommended</translation>
    </message>
    <message>
        <source>small margins: {} deg of phase, a factor {} of gain</source>
        <translation>裕度偏小：相位 {} 度，幅值 {} 倍</translation>
    </message>
    <message>
        <source>the usual least are 30 deg and a factor 2</source>
        <translation>通常至少为 30 度和 2 倍</translation>
    </message>
    <message>
        <source>friction holds the rotor within +-{} deg of the reference</source>
        <translation>摩擦使转子停在参考值 ±{} 度范围内</translation>
    </message>
    <message>
        <source>only the integral removes the rest, slowly; the micro-step assist or a larger K_P narrows the band</source>
        <translation>剩余误差只靠积分缓慢消除；微步辅助或更大的 K_P 可缩小该带</translation>
    </message>
    <message>
        <source>the micro-step assist or a larger K_P narrows the band</source>
        <translation>微步辅助或更大的 K_P 可缩小该带</translation>
    </message>
    <message>
        <source>the stray field of the coils is not compensated and feeds the current back into the angle: this gain can make it alternate every sample</source>
        <translation>线圈杂散磁场未补偿，电流会反馈到角度：此增益可能使电流每个采样都交替变号</translation>
    </message>
    <message>
        <source>switch the compensation on (stray.enabled)</source>
        <translation>请打开补偿（stray.enabled）</translation>
    </message>
    <message>
        <source>this gain needs the stray coefficient to better than {} %, and its error is not known</source>
        <translation>此增益要求杂散磁场系数误差小于 {} %，而其误差未知</translation>
    </message>
    <message>
        <source>calibrate the stray field first</source>
        <translation>请先标定杂散磁场</translation>
    </message>
    <message>
        <source>the stray coefficient is known to {} %, this gain needs better than {} %</source>
        <translation>杂散磁场系数的误差为 {} %，此增益要求小于 {} %</translation>
    </message>
    <message>
        <source>calibrate the stray field again, or lower the gains</source>
        <translation>请重新标定杂散磁场，或降低增益</translation>
    </message>
    <message>
        <source>steps above {} deg reach the current limit of {} A; with it and with friction a step of {} deg overshoots by {} %</source>
        <translation>大于 {} 度的阶跃会达到电流限值 {} A；计入该限值和摩擦，{} 度阶跃的超调为 {} %</translation>
    </message>
    <message>
        <source>lead large moves along a ramp, or choose a slower loop</source>
        <translation>大幅运动请用斜坡引导，或选择较慢的回路</translation>
    </message>
    <message>
        <source>`halbench describe` lists the parameters.</source>
        <translation>“halbench describe”会列出参数。</translation>
    </message>
    <message>
        <source>{} reads {} after writing {}</source>
        <translation>{} 读回为 {}，而写入的是 {}</translation>
    </message>
    <message>
        <source>The old values run again; check the device&apos;s limits.</source>
        <translation>已恢复原值；请检查设备的限值。</translation>
    </message>
    <message>
        <source>a {} has no prediction to verify against</source>
        <translation>“{}”没有可供验证的预测</translation>
    </message>
    <message>
        <source>Verify with a step, ramp, sine or staircase.</source>
        <translation>请用阶跃、斜坡、正弦或阶梯来验证。</translation>
    </message>
    <message>
        <source>{} was {} {}, the prediction allows {} {}</source>
        <translation>{}为 {} {}，预测允许 {} {}</translation>
    </message>
    <message>
        <source>The old values run again. Identify the motor anew, or choose calmer gains.</source>
        <translation>已恢复原值。请重新辨识电机，或选择较缓和的增益。</translation>
    </message>
    <message>
        <source>final error</source>
        <translation>终值误差</translation>
    </message>
    <message>
        <source>rms error</source>
        <translation>均方根误差</translation>
    </message>
    <message>
        <source>the readings lie {} % of the amplitude away from their ellipse</source>
        <translation>读数偏离其椭圆达幅值的 {} %</translation>
    </message>
    <message>
        <source>look for saturated sensors or a loose magnet</source>
        <translation>请检查传感器是否饱和或磁体是否松动</translation>
    </message>
    <message>
        <source>spins slowly for the Hall sensors</source>
        <translation>为标定霍尔传感器而慢速旋转</translation>
    </message>
    <message>
        <source>use a spin current above the breakaway current</source>
        <translation>请使用大于起动电流的旋转电流</translation>
    </message>
    <message>
        <source>the angle error of {} degrees rms that the ellipse leaves is not known well enough ({} degrees: ripple of the speed and scatter)</source>
        <translation>椭圆剩余的角度误差 {} 度（均方根）了解得不够准确（{} 度：转速波动和离散）</translation>
    </message>
    <message>
        <source>the ellipse alone is as good</source>
        <translation>仅用椭圆同样好</translation>
    </message>
    <message>
        <source>the rotor did not turn fast and long enough to show the angle error that the ellipse leaves</source>
        <translation>转子转得不够快、不够久，无法显示椭圆剩余的角度误差</translation>
    </message>
    <message>
        <source>allow a higher current or speed</source>
        <translation>请允许更大的电流或转速</translation>
    </message>
    <message>
        <source>spins fast for the angle error</source>
        <translation>为测角度误差而快速旋转</translation>
    </message>
    <message>
        <source>no calibration was chosen</source>
        <translation>未选择任何标定</translation>
    </message>
    <message>
        <source>choose hall, stray, static-friction or all</source>
        <translation>请选择 hall、stray、static-friction 或 all</translation>
    </message>
    <message>
        <source>the currents of a calibration must lie in (0, 4] A</source>
        <translation>标定电流必须在 (0, 4] A 范围内</translation>
    </message>
    <message>
        <source>2 to 50 starts in each direction are possible</source>
        <translation>每个方向可起动 2 到 50 次</translation>
    </message>
    <message>
        <source>turns to another angle</source>
        <translation>转到另一角度</translation>
    </message>
    <message>
        <source>d-axis current at rest</source>
        <translation>静止时的 d 轴电流</translation>
    </message>
    <message>
        <source>ramps the current from rest</source>
        <translation>从静止逐渐增大电流</translation>
    </message>
    <message>
        <source>the rotor broke loose in too few of the ramps</source>
        <translation>转子在太少的斜坡中起动</translation>
    </message>
    <message>
        <source>ramp to a higher current</source>
        <translation>请升到更大的电流</translation>
    </message>
    <message>
        <source>the rate must be more than zero</source>
        <translation>采样率必须大于零</translation>
    </message>
    <message>
        <source>Give e.g. --rate 1000.</source>
        <translation>例如给出 --rate 1000。</translation>
    </message>
    <message>
        <source>a capture at {} Hz is not possible</source>
        <translation>无法以 {} Hz 捕获</translation>
    </message>
    <message>
        <source>the rate must divide that of the loop, {} Hz; the nearest is {} Hz</source>
        <translation>采样率必须能整除回路频率 {} Hz；最接近的是 {} Hz</translation>
    </message>
    <message>
        <source>the share of rows before the trigger lies from 0 to below 1</source>
        <translation>触发前的数据比例必须从 0 到小于 1</translation>
    </message>
    <message>
        <source>Give e.g. --pre-trigger 0.25.</source>
        <translation>例如给出 --pre-trigger 0.25。</translation>
    </message>
    <message>
        <source>the wait for the trigger must be more than zero seconds</source>
        <translation>等待触发的时间必须大于零秒</translation>
    </message>
    <message>
        <source>Give e.g. --wait 10.</source>
        <translation>例如给出 --wait 10。</translation>
    </message>
    <message>
        <source>a capture takes 1 to {} signals</source>
        <translation>一次捕获可含 1 到 {} 个信号</translation>
    </message>
    <message>
        <source>record a stream for more</source>
        <translation>如需更多，请记录数据流</translation>
    </message>
    <message>
        <source>`halbench describe` lists the signals.</source>
        <translation>“halbench describe”会列出信号。</translation>
    </message>
    <message>
        <source>the signal &apos;{}&apos; is named twice</source>
        <translation>信号“{}”被指定了两次</translation>
    </message>
    <message>
        <source>Name every signal once.</source>
        <translation>每个信号只指定一次。</translation>
    </message>
    <message>
        <source>the trigger did not come within {} s</source>
        <translation>触发在 {} s 内没有到来</translation>
    </message>
    <message>
        <source>wait longer with --wait, or choose another --trigger</source>
        <translation>请用 --wait 等待更久，或选择其他 --trigger</translation>
    </message>
    <message>
        <source>waits for the trigger</source>
        <translation>等待触发</translation>
    </message>
    <message>
        <source>the board captured other signals than it was asked for</source>
        <translation>控制板捕获的信号与要求的不同</translation>
    </message>
    <message>
        <source>another program may be using its capture; try again</source>
        <translation>可能有其他程序正在使用其捕获功能；请重试</translation>
    </message>
    <message>
        <source>a captured value is not a number</source>
        <translation>捕获的某个值不是数字</translation>
    </message>
    <message>
        <source>The board or the link delivers damaged values; nothing was kept of them.</source>
        <translation>控制板或链路传来损坏的数值；未保留任何数值。</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no trigger</source>
        <translation>“{}”不是触发条件</translation>
    </message>
    <message>
        <source>use now, reference, SIGNAL&gt;LEVEL (rising) or SIGNAL&lt;LEVEL (falling)</source>
        <translation>请使用 now、reference、SIGNAL&gt;LEVEL（上升）或 SIGNAL&lt;LEVEL（下降）</translation>
    </message>
    <message>
        <source>the level of a trigger is not finite</source>
        <translation>触发电平不是有限数</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>请给出一个数字</translation>
    </message>
    <message>
        <source>a coil is at {} degC and does not cool below {} degC</source>
        <translation>有一个线圈为 {} °C，且无法冷却到 {} °C 以下</translation>
    </message>
    <message>
        <source>Cool the motor&apos;s surroundings and try again.</source>
        <translation>请降低电机周围的温度后重试。</translation>
    </message>
    <message>
        <source>waits for the coils to cool: {} degC</source>
        <translation>等待线圈冷却：{} °C</translation>
    </message>
    <message>
        <source>a coil temperature is not a number</source>
        <translation>有一个线圈温度不是数字</translation>
    </message>
    <message>
        <source>Nothing is armed without it; check the temperature sensors.</source>
        <translation>没有它就不会使能；请检查温度传感器。</translation>
    </message>
    <message>
        <source>the coils would reach {} degC, more than {} degC</source>
        <translation>线圈将达到 {} °C，超过 {} °C</translation>
    </message>
    <message>
        <source>Shorten it, use less current, or let the motor cool first. Nothing was armed.</source>
        <translation>请缩短时间、减小电流，或先让电机冷却。尚未使能。</translation>
    </message>
    <message>
        <source>give it in SI units, e.g. J=5.5e-4</source>
        <translation>请用 SI 单位给出，例如 J=5.5e-4</translation>
    </message>
    <message>
        <source>{} = {} is not possible</source>
        <translation>{} = {} 不可行</translation>
    </message>
    <message>
        <source>it cannot be negative</source>
        <translation>不能为负</translation>
    </message>
    <message>
        <source>it must be more than zero</source>
        <translation>必须大于零</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no constant of the motor</source>
        <translation>“{}”不是电机常数</translation>
    </message>
    <message>
        <source>use J, c, Kf or phi</source>
        <translation>请使用 J、c、Kf 或 phi</translation>
    </message>
    <message>
        <source>the currents of the sweep are not finite numbers</source>
        <translation>扫描电流含有非有限数</translation>
    </message>
    <message>
        <source>write e.g. 1.6:4:0.2</source>
        <translation>例如写成 1.6:4:0.2</translation>
    </message>
    <message>
        <source>the sweep needs 0 &lt; FROM &lt;= TO and STEP &gt; 0</source>
        <translation>扫描要求 0 &lt; 起始 &lt;= 终止，且步长 &gt; 0</translation>
    </message>
    <message>
        <source>{} A is beyond the device&apos;s limit of {} A</source>
        <translation>{} A 超出设备限值 {} A</translation>
    </message>
    <message>
        <source>end the sweep at or below limit.current</source>
        <translation>扫描终止电流不要超过 limit.current</translation>
    </message>
    <message>
        <source>a sweep of more than 29 currents does not fit the board</source>
        <translation>超过 29 个电流的扫描无法装入控制板</translation>
    </message>
    <message>
        <source>use a larger step</source>
        <translation>请使用更大的步长</translation>
    </message>
    <message>
        <source>the recording holds hardly any rows</source>
        <translation>记录几乎没有数据行</translation>
    </message>
    <message>
        <source>record at least some seconds of motion</source>
        <translation>请至少记录几秒钟的运动</translation>
    </message>
    <message>
        <source>the recording lacks position or current_command</source>
        <translation>记录缺少 position 或 current_command</translation>
    </message>
    <message>
        <source>it needs the columns time_s, position_rad and current_command_A</source>
        <translation>需要 time_s、position_rad 和 current_command_A 列</translation>
    </message>
    <message>
        <source>the recording has {} rows a second, less than 100</source>
        <translation>记录每秒 {} 行，少于 100 行</translation>
    </message>
    <message>
        <source>record at 100 Hz or more</source>
        <translation>请以 100 Hz 或更高的采样率记录</translation>
    </message>
    <message>
        <source>the rotor stopped</source>
        <translation>转子停住</translation>
    </message>
    <message>
        <source>slower than {} rad/s</source>
        <translation>低于 {} rad/s</translation>
    </message>
    <message>
        <source>not steady at its end</source>
        <translation>结束时未达稳态</translation>
    </message>
    <message>
        <source>the motion does not bend enough to show c/J</source>
        <translation>运动曲线弯曲不足，无法显示 c/J</translation>
    </message>
    <message>
        <source>friction differs between the directions by {} % of its mean</source>
        <translation>两个方向的摩擦相差平均值的 {} %</translation>
    </message>
    <message>
        <source>the mean of both directions is reported</source>
        <translation>给出的是两个方向的平均值</translation>
    </message>
    <message>
        <source>{} plateaus came to rest and were left out</source>
        <translation>{} 个平台中转子停住，已剔除</translation>
    </message>
    <message>
        <source>start the sweep further above the breakaway current</source>
        <translation>请让扫描从更高于起动电流处开始</translation>
    </message>
    <message>
        <source>dwell longer at each current</source>
        <translation>每个电流请保持更久</translation>
    </message>
    <message>
        <source>{} rows of the recording were lost</source>
        <translation>记录丢失了 {} 行</translation>
    </message>
    <message>
        <source>run-ups and coast-downs could not be used: {}</source>
        <translation>升速和自由减速数据无法使用：{}</translation>
    </message>
    <message>
        <source>record run-ups and coast-downs at 100 Hz or more</source>
        <translation>请以 100 Hz 或更高的采样率记录升速和自由减速</translation>
    </message>
    <message>
        <source>use a higher current, so that the coast-down above 3 rad/s lasts longer than 0.12 s, or a second current</source>
        <translation>请用更大的电流，使 3 rad/s 以上的自由减速超过 0.12 s，或增加第二个电流</translation>
    </message>
    <message>
        <source>model inadequate: one stretch of motion lies {} times further off the model than most</source>
        <translation>模型不充分：有一段运动偏离模型的程度是多数的 {} 倍</translation>
    </message>
    <message>
        <source>friction may depend on speed: the intervals do not hold that error; use faster currents only</source>
        <translation>摩擦可能与转速有关：区间未包含此误差；请只用较大的电流</translation>
    </message>
    <message>
        <source>the torque changes with the speed as no lag of the currents explains: the angle of commutation or the compensation of the stray field is wrong</source>
        <translation>转矩随转速的变化无法用电流滞后解释：换相角或杂散磁场的补偿有误</translation>
    </message>
    <message>
        <source>calibrate the stray field and the Hall sensors, then identify again</source>
        <translation>请校准杂散磁场和霍尔传感器，然后重新辨识</translation>
    </message>
    <message>
        <source>ordinary and robust regression of the sweep differ by more than one standard error</source>
        <translation>扫描的普通回归与稳健回归相差超过一个标准误差</translation>
    </message>
    <message>
        <source>look at the plateaus of low weight; repeat the sweep</source>
        <translation>请查看权重低的平台；重新扫描</translation>
    </message>
    <message>
        <source>the sweep is not a straight line (lack of fit, p = {})</source>
        <translation>扫描结果不是直线（失拟，p = {}）</translation>
    </message>
    <message>
        <source>friction may depend on speed; use only the range of speeds that matters</source>
        <translation>摩擦可能与转速有关；请只用所关心的转速范围</translation>
    </message>
    <message>
        <source>residuals keep their sign over neighbouring speeds (runs test, p = {})</source>
        <translation>相邻转速的残差符号相同（游程检验，p = {}）</translation>
    </message>
    <message>
        <source>friction may depend on speed; look at the residuals</source>
        <translation>摩擦可能与转速有关；请查看残差</translation>
    </message>
    <message>
        <source>leaving out one plateau moves the steady line by {} standard errors</source>
        <translation>去掉一个平台会使稳态直线移动 {} 个标准误差</translation>
    </message>
    <message>
        <source>add plateaus near it or repeat it</source>
        <translation>请在其附近增加平台或重测</translation>
    </message>
    <message>
        <source>c/phi is {} A*s/rad from plateaus and {} from all motion (p = {})</source>
        <translation>c/phi 由平台得 {} A*s/rad，由全部运动得 {}（p = {}）</translation>
    </message>
    <message>
        <source>friction may depend on speed</source>
        <translation>摩擦可能与转速有关</translation>
    </message>
    <message>
        <source>the given constants contradict the data (p = {})</source>
        <translation>给定的常数与数据矛盾（p = {}）</translation>
    </message>
    <message>
        <source>give only the constant that is known best</source>
        <translation>只给出最有把握的常数</translation>
    </message>
    <message>
        <source>only ratios of the constants can be known from angle and current</source>
        <translation>由角度和电流只能得到常数之间的比值</translation>
    </message>
    <message>
        <source>give the inertia (--given J=...) or the torque constant (--given phi=...), or repeat with a known inertia fixed to the rotor (--bare, --added-inertia)</source>
        <translation>请给出转动惯量（--given J=...）或转矩常数（--given phi=...），或在转子上固定已知惯量后重测（--bare, --added-inertia）</translation>
    </message>
    <message>
        <source>the data and the given constants do not decide all four constants</source>
        <translation>数据和给定的常数不足以确定全部四个常数</translation>
    </message>
    <message>
        <source>add what is missing: transients (run-up and coast-down), or another given constant</source>
        <translation>请补上所缺的：过渡过程（升速和自由减速）或另一个给定常数</translation>
    </message>
    <message>
        <source>both runs must decide c/J, K_f/J and phi/J with their covariance, and be made without given constants</source>
        <translation>两次测量都必须确定 c/J、K_f/J 和 phi/J 及其协方差，且不使用给定常数</translation>
    </message>
    <message>
        <source>identify the bare motor again without --given</source>
        <translation>请不用 --given 重新辨识裸电机</translation>
    </message>
    <message>
        <source>damping tells another inertia ({} standard errors): the added part changed the friction</source>
        <translation>由阻尼得到不同的惯量（相差 {} 个标准误差）：附加件改变了摩擦</translation>
    </message>
    <message>
        <source>only the torque constant was used</source>
        <translation>只使用了转矩常数</translation>
    </message>
    <message>
        <source>neither transients nor plateaus could be used: {}; {}</source>
        <translation>过渡过程和平台数据都无法使用：{}；{}</translation>
    </message>
    <message>
        <source>use currents well above the breakaway current and hold each for some seconds</source>
        <translation>请使用明显高于起动电流的电流，每个保持数秒</translation>
    </message>
    <message>
        <source>sweep forward</source>
        <translation>正向扫描</translation>
    </message>
    <message>
        <source>sweep reverse</source>
        <translation>反向扫描</translation>
    </message>
    <message>
        <source>coast-downs forward</source>
        <translation>正向自由减速</translation>
    </message>
    <message>
        <source>coast-downs reverse</source>
        <translation>反向自由减速</translation>
    </message>
    <message>
        <source>the speed limit leaves no usable speed</source>
        <translation>转速限值下没有可用的转速</translation>
    </message>
    <message>
        <source>allow e.g. 40 rad/s</source>
        <translation>例如允许 40 rad/s</translation>
    </message>
    <message>
        <source>0 to 16 coast-downs in each direction are possible</source>
        <translation>每个方向可自由减速 0 到 16 次</translation>
    </message>
    <message>
        <source>first motion</source>
        <translation>首次运动</translation>
    </message>
    <message>
        <source>the model does not hold {}, which decides the loop</source>
        <translation>模型中没有决定回路的 {}</translation>
    </message>
    <message>
        <source>steady speeds alone do not show the inertia: identify with run-ups and coast-downs, or give the constant that is known (--given J=...)</source>
        <translation>仅有稳态转速无法显示惯量：请用升速和自由减速辨识，或给出已知常数（--given J=...）</translation>
    </message>
    <message>
        <source>{} of the model is not a finite number</source>
        <translation>模型的 {} 不是有限数</translation>
    </message>
    <message>
        <source>the covariance of the model names {} values but is not {} x {}</source>
        <translation>模型的协方差列出 {} 个值，但不是 {} x {} 矩阵</translation>
    </message>
    <message>
        <source>the covariance of the model holds a value that is not finite</source>
        <translation>模型的协方差含有非有限值</translation>
    </message>
    <message>
        <source>the covariance names &apos;{}&apos;, of which the model has no value</source>
        <translation>协方差列出了“{}”，而模型没有该值</translation>
    </message>
    <message>
        <source>the response has too few samples to be measured</source>
        <translation>响应的样本太少，无法测量</translation>
    </message>
    <message>
        <source>Record longer or at a higher rate.</source>
        <translation>请记录更久或使用更高的采样率。</translation>
    </message>
    <message>
        <source>the response holds a value that is not a number</source>
        <translation>响应中有一个值不是数字</translation>
    </message>
    <message>
        <source>Repeat the move.</source>
        <translation>请重复该运动。</translation>
    </message>
    <message>
        <source>{} degrees</source>
        <translation>{} 度</translation>
    </message>
    <message>
        <source>a move of {} s is out of range</source>
        <translation>运动时间 {} s 超出范围</translation>
    </message>
    <message>
        <source>Allowed: 0.05 to 3600 s.</source>
        <translation>允许：0.05 到 3600 s。</translation>
    </message>
    <message>
        <source>the board did not start its reference</source>
        <translation>控制板没有启动参考信号</translation>
    </message>
    <message>
        <source>{} of {} samples arrived</source>
        <translation>收到 {} 个样本，应为 {} 个</translation>
    </message>
    <message>
        <source>the board followed another reference than commanded, {} away</source>
        <translation>控制板跟随的参考值与指令不同，相差 {}</translation>
    </message>
    <message>
        <source>waits for standstill</source>
        <translation>等待静止</translation>
    </message>
    <message>
        <source>the device knows no zero of its axes and does not find it</source>
        <translation>设备不知道各轴的零点，也找不到零点</translation>
    </message>
    <message>
        <source>Check its sensors, home it, and move again. Nothing was armed.</source>
        <translation>请检查传感器，执行回零，然后重新运动。未使能任何输出。</translation>
    </message>
    <message>
        <source>a {} needs {}</source>
        <translation>“{}”需要 {}</translation>
    </message>
    <message>
        <source>Add {}=... to the reference.</source>
        <translation>请在参考信号中加上 {}=...。</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not KEY=VALUE</source>
        <translation>“{}”不是 KEY=VALUE 的形式</translation>
    </message>
    <message>
        <source>Write a reference like step,amplitude_deg=100. Known keys: {}.</source>
        <translation>参考信号写法如 step,amplitude_deg=100。已知的键：{}。</translation>
    </message>
    <message>
        <source>Write {}=1.5.</source>
        <translation>请写成 {}=1.5。</translation>
    </message>
    <message>
        <source>there is no reference shape &apos;{}&apos;</source>
        <translation>没有参考波形“{}”</translation>
    </message>
    <message>
        <source>Known shapes: {}.</source>
        <translation>已知波形：{}。</translation>
    </message>
    <message>
        <source>a reference has no key &apos;{}&apos;</source>
        <translation>参考信号没有键“{}”</translation>
    </message>
    <message>
        <source>Allowed: {} to {}.</source>
        <translation>允许：{} 到 {}。</translation>
    </message>
    <message>
        <source>Allowed: {} to {}{}.</source>
        <translation>允许：{} 到 {}{}。</translation>
    </message>
    <message>
        <source>{} does not go with the other keys: a length beside an angle</source>
        <translation>{} 与其他键不一致：长度与角度混用</translation>
    </message>
    <message>
        <source>reference: &apos;{}&apos; is given twice</source>
        <translation>参考信号：“{}”给出了两次</translation>
    </message>
    <message>
        <source>axis {} turns, and the reference is a length</source>
        <translation>轴 {} 是旋转轴，而参考值是长度</translation>
    </message>
    <message>
        <source>axis {} moves along a line, and the reference is an angle</source>
        <translation>轴 {} 是直线轴，而参考值是角度</translation>
    </message>
    <message>
        <source>{} is not a number at {} s</source>
        <translation>{} 在 {} s 处不是数字</translation>
    </message>
    <message>
        <source>The board or the link delivers damaged values; nothing was concluded from them.</source>
        <translation>控制板或链路传来损坏的数值；未据此得出任何结论。</translation>
    </message>
    <message>
        <source>the duration must be more than zero seconds</source>
        <translation>持续时间必须大于零秒</translation>
    </message>
    <message>
        <source>Give e.g. --duration 10.</source>
        <translation>例如给出 --duration 10。</translation>
    </message>
    <message>
        <source>Give e.g. --rate 100.</source>
        <translation>例如给出 --rate 100。</translation>
    </message>
    <message>
        <source>a duration of {} s at {} Hz is more than {} rows</source>
        <translation>{} s、{} Hz 超过 {} 行</translation>
    </message>
    <message>
        <source>Record in pieces or at a lower rate.</source>
        <translation>请分段记录或使用较低的采样率。</translation>
    </message>
    <message>
        <source>only {} of {} samples arrived</source>
        <translation>只收到 {} 个样本，应为 {} 个</translation>
    </message>
    <message>
        <source>{} of {} rows are missing</source>
        <translation>缺少 {} 行，共 {} 行</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>没有写入任何内容</translation>
    </message>
    <message>
        <source>the source&apos;s own targets (zeta 0.06 at 15 rad/s) give {} A/rad and {} A/(rad s) on this motor, not the printed 10 and 0.1</source>
        <translation>文献自己的目标（zeta 0.06，15 rad/s）在此电机上得到 {} A/rad 和 {} A/(rad s)，而不是所印的 10 和 0.1</translation>
    </message>
    <message>
        <source>method designed has those gains</source>
        <translation>方法 designed 即采用这些增益</translation>
    </message>
    <message>
        <source>the motor damps more than the loop asks for: K_D is zero</source>
        <translation>电机本身的阻尼超过回路要求：K_D 为零</translation>
    </message>
    <message>
        <source>a faster loop may be possible: method bandwidth or phase-margin</source>
        <translation>也许可以用更快的回路：方法 bandwidth 或 phase-margin</translation>
    </message>
    <message>
        <source>the model has no covariance: robustness is that of an exactly known motor</source>
        <translation>模型没有协方差：鲁棒性按精确已知的电机计算</translation>
    </message>
    <message>
        <source>identify the motor to get its uncertainty</source>
        <translation>请辨识电机以得到其不确定度</translation>
    </message>
    <message>
        <source>{} % of the motors that the data allow make this loop unstable</source>
        <translation>在数据允许的电机中，{} % 会使此回路不稳定</translation>
    </message>
    <message>
        <source>identify more precisely, or choose a slower loop</source>
        <translation>请更精确地辨识，或选择较慢的回路</translation>
    </message>
    <message>
        <source>the set of gains lacks {}</source>
        <translation>增益组缺少 {}</translation>
    </message>
    <message>
        <source>{} = {} is negative</source>
        <translation>{} = {} 为负</translation>
    </message>
    <message>
        <source>the device has no parameter {}, which this set of gains needs</source>
        <translation>设备没有此增益组需要的参数 {}</translation>
    </message>
    <message>
        <source>choose a method without it: pole-placement or a preset</source>
        <translation>请选择不需要它的方法：pole-placement 或某个预设</translation>
    </message>
    <message>
        <source>ended by the user</source>
        <translation>由用户结束</translation>
    </message>
    <message>
        <source>the old gains run again</source>
        <translation>已恢复原增益</translation>
    </message>
    <message>
        <source>no device is connected</source>
        <translation>没有连接设备</translation>
    </message>
    <message>
        <source>connect one first</source>
        <translation>请先连接设备</translation>
    </message>
    <message>
        <source>Connection refused</source>
        <translation>连接被拒绝</translation>
    </message>
    <message>
        <source>Connection timed out</source>
        <translation>连接超时</translation>
    </message>
    <message>
        <source>Connection reset by peer</source>
        <translation>连接被对方重置</translation>
    </message>
    <message>
        <source>Network is unreachable</source>
        <translation>网络不可达</translation>
    </message>
    <message>
        <source>No route to host</source>
        <translation>没有到主机的路由</translation>
    </message>
    <message>
        <source>Name or service not known</source>
        <translation>名称或服务未知</translation>
    </message>
    <message>
        <source>Temporary failure in name resolution</source>
        <translation>域名解析暂时失败</translation>
    </message>
    <message>
        <source>Address already in use</source>
        <translation>地址已被使用</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>没有该文件或文件夹</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>权限不够</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>磁盘空间不足</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>是文件夹</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>不是文件夹</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>文件已存在</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>文件太大</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>只读文件系统</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>打开的文件过多</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>输入输出错误</translation>
    </message>
    <message>
        <source>Unknown error</source>
        <translation>未知错误</translation>
    </message>
    <message>
        <source>device &apos;{}&apos;: {}={}</source>
        <translation>设备“{}”：{}={}</translation>
    </message>
    <message>
        <source>use {}</source>
        <translation>请使用 {}</translation>
    </message>
    <message>
        <source>give one octet in hexadecimal digits, like 9A</source>
        <translation>请用十六进制给出一个字节，例如 9A</translation>
    </message>
    <message>
        <source>give a whole number from {} to {}</source>
        <translation>请给出 {} 到 {} 的整数</translation>
    </message>
    <message>
        <source>device &apos;{}&apos;: sync and escape are the same</source>
        <translation>设备“{}”：sync 与 escape 相同</translation>
    </message>
    <message>
        <source>give two different octets</source>
        <translation>请给出两个不同的字节</translation>
    </message>
    <message>
        <source>{} is not open</source>
        <translation>{} 未打开</translation>
    </message>
    <message>
        <source>connect again</source>
        <translation>请重新连接</translation>
    </message>
    <message>
        <source>{} (process {})</source>
        <translation>{}（进程 {}）</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>某个程序</translation>
    </message>
    <message>
        <source>this program</source>
        <translation>本程序</translation>
    </message>
    <message>
        <source>install the rules that &apos;halbench devices --udev-rules&apos; prints, then plug the device in again</source>
        <translation>请安装“halbench devices --udev-rules”输出的规则，然后重新插入设备</translation>
    </message>
    <message>
        <source>, or join the group with &apos;sudo usermod -aG {} $USER&apos; and log in again</source>
        <translation>，或用“sudo usermod -aG {} $USER”加入用户组并重新登录</translation>
    </message>
    <message>
        <source>no permission to use {}</source>
        <translation>没有使用 {} 的权限</translation>
    </message>
    <message>
        <source>{} is in use by {}</source>
        <translation>{} 正被以下程序使用：{}</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>另一个程序</translation>
    </message>
    <message>
        <source>disconnect it first</source>
        <translation>请先断开</translation>
    </message>
    <message>
        <source>close that program (ModemManager lets go of a new port after some seconds)</source>
        <translation>请关闭该程序（ModemManager 会在几秒后释放新端口）</translation>
    </message>
    <message>
        <source>{} is not there</source>
        <translation>{} 不存在</translation>
    </message>
    <message>
        <source>plug the device in and see &apos;halbench devices&apos; for its address</source>
        <translation>请插入设备，用“halbench devices”查看其地址</translation>
    </message>
    <message>
        <source>check the cable and that the board is on</source>
        <translation>请检查电缆以及控制板是否已通电</translation>
    </message>
    <message>
        <source>name a serial port: see &apos;halbench devices&apos;</source>
        <translation>请指定串口：见“halbench devices”</translation>
    </message>
    <message>
        <source>{} cannot run at {} baud</source>
        <translation>{} 不能以 {} 波特运行</translation>
    </message>
    <message>
        <source>use 115200 or a rate that the adapter knows</source>
        <translation>请使用 115200 或适配器支持的波特率</translation>
    </message>
    <message>
        <source>serial:{}: the device was unplugged or switched off</source>
        <translation>serial:{}：设备已被拔出或关闭</translation>
    </message>
    <message>
        <source>serial:{}: the board takes no more commands</source>
        <translation>serial:{}：控制板不再接受命令</translation>
    </message>
    <message>
        <source>LEN byte</source>
        <translation>LEN 字节</translation>
    </message>
    <message>
        <source>LEN+CTR byte</source>
        <translation>LEN+CTR 字节</translation>
    </message>
    <message>
        <source>LEN+FILL byte</source>
        <translation>LEN+FILL 字节</translation>
    </message>
    <message>
        <source>LEN word</source>
        <translation>LEN 字</translation>
    </message>
    <message>
        <source>LEN+CTR words</source>
        <translation>LEN+CTR 字</translation>
    </message>
    <message>
        <source>LEN+FILL words</source>
        <translation>LEN+FILL 字</translation>
    </message>
    <message>
        <source>no checksum</source>
        <translation>无校验和</translation>
    </message>
    <message>
        <source>byte checksum</source>
        <translation>字节校验和</translation>
    </message>
    <message>
        <source>word checksum</source>
        <translation>字校验和</translation>
    </message>
    <message>
        <source>not framed</source>
        <translation>无帧</translation>
    </message>
    <message>
        <source>{} sends something ({} octets), but not in this protocol</source>
        <translation>{} 发送了数据（{} 字节），但不是此协议</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a finite number</source>
        <translation>“{}”必须是有限数</translation>
    </message>
    <message>
        <source>a [[plot]] has both min and max, or neither; min is less than max</source>
        <translation>[[plot]] 要么同时有 min 和 max，要么都没有；min 小于 max</translation>
    </message>
    <message>
        <source>&apos;plot&apos; must be a list of tables, [[plot]]</source>
        <translation>“plot”必须是表的列表，[[plot]]</translation>
    </message>
    <message>
        <source>&apos;monitor&apos; must be a table</source>
        <translation>“monitor”必须是表</translation>
    </message>
    <message>
        <source>&apos;span_s&apos; must be more than 0</source>
        <translation>“span_s”必须大于 0</translation>
    </message>
    <message>
        <source>{}: given up</source>
        <translation>{}：已放弃</translation>
    </message>
    <message>
        <source>a stop was sent before the board had answered</source>
        <translation>在控制板应答之前发送了停止</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>请重试</translation>
    </message>
    <message>
        <source>a stop came in between</source>
        <translation>其间发生了停止</translation>
    </message>
    <message>
        <source>release the stop again when the cause is gone</source>
        <translation>原因排除后请再次解除停止</translation>
    </message>
    <message>
        <source>{} is open in another window (process {} on {})</source>
        <translation>{} 已在另一个窗口中打开（进程 {}，计算机 {}）</translation>
    </message>
    <message>
        <source>close it there; if it is open nowhere, remove {}</source>
        <translation>请在那里关闭它；如果哪里都没有打开，请删除 {}</translation>
    </message>
    <message>
        <source>{}: the device was unplugged or switched off</source>
        <translation>{}：设备已拔出或已断电</translation>
    </message>
    <message>
        <source>{} cannot be opened: {}</source>
        <translation>无法打开 {}：{}</translation>
    </message>
    <message>
        <source>its serial port has no driver</source>
        <translation>其串口没有驱动程序</translation>
    </message>
    <message>
        <source>serial port</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>USB bulk device</source>
        <translation>USB 批量传输设备</translation>
    </message>
    <message>
        <source>HID device</source>
        <translation>HID 设备</translation>
    </message>
    <message>
        <source>no {} {} is plugged in</source>
        <translation>未接入 {} {}</translation>
    </message>
    <message>
        <source>{}: it is a {}</source>
        <translation>{}：该设备是 {}</translation>
    </message>
    <message>
        <source>name it {}</source>
        <translation>请使用名称 {}</translation>
    </message>
    <message>
        <source>{}: the one there has the serial number &apos;{}&apos;</source>
        <translation>{}：现有设备的序列号为 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>plug the right one in, or name {}</source>
        <translation>请接入正确的设备，或使用 {}</translation>
    </message>
    <message>
        <source>plug it in and see &apos;halbench devices&apos; for its address</source>
        <translation>请接入设备；&apos;halbench devices&apos; 会显示其地址</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not VID:PID[:SERIAL]</source>
        <translation>&apos;{}&apos; 不是 VID:PID[:序列号]</translation>
    </message>
    <message>
        <source>write both numbers in hexadecimal digits, like 1209:0001</source>
        <translation>请用十六进制写出两个编号，例如 1209:0001</translation>
    </message>
    <message>
        <source>several devices {} are plugged in</source>
        <translation>接入了多个 {} 设备</translation>
    </message>
    <message>
        <source>name one: {} or {}</source>
        <translation>请指定其一：{} 或 {}</translation>
    </message>
    <message>
        <source>USB cannot be used</source>
        <translation>无法使用 USB</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>无法打开</translation>
    </message>
    <message>
        <source>cannot be claimed</source>
        <translation>无法占用</translation>
    </message>
    <message>
        <source>{}: the board halted its endpoint</source>
        <translation>{}：控制板停止了其端点</translation>
    </message>
    <message>
        <source>{}: the board takes no more commands</source>
        <translation>{}：控制板不再接收命令</translation>
    </message>
    <message>
        <source>a stop came in between, so this was not done</source>
        <translation>其间发生了停止，因此未执行</translation>
    </message>
    <message>
        <source>find out why it was stopped, then do it again</source>
        <translation>查明停止原因后再执行一次</translation>
    </message>
    <message>
        <source>{}; it is not confirmed that the values from before are back: {}</source>
        <translation>{}；未确认先前的值已恢复：{}</translation>
    </message>
    <message>
        <source>connect again and compare the parameters before the actuator is armed</source>
        <translation>请重新连接，并在使能执行器之前核对参数</translation>
    </message>
    <message>
        <source>Current of one plateau</source>
        <translation>一个平台的电流</translation>
    </message>
    <message>
        <source>output converter does not answer</source>
        <translation>输出转换器无应答</translation>
    </message>
    <message>
        <source>{}: {} is not a finite number</source>
        <translation>{}：{} 不是有限数</translation>
    </message>
    <message>
        <source>{}: {} is not from 0 to {}</source>
        <translation>{}：{} 不在 0 到 {} 之间</translation>
    </message>
    <message>
        <source>give the share of the messages, e.g. 0.01 for one in a hundred</source>
        <translation>请给出消息的比例，例如 0.01 表示百分之一</translation>
    </message>
    <message>
        <source>give milliseconds, e.g. 20</source>
        <translation>请给出毫秒数，例如 20</translation>
    </message>
    <message>
        <source>{} % of the recording&apos;s rows are missing</source>
        <translation>记录中缺失 {} % 的行</translation>
    </message>
    <message>
        <source>{}: {}; that is not this protocol</source>
        <translation>{}：{}；这不是本协议</translation>
    </message>
    <message>
        <source>check address and port: another program listens there</source>
        <translation>请检查地址和端口：那里是另一个程序在监听</translation>
    </message>
    <message>
        <source>check that it is the right device and address, and on a serial line its baud rate and framing</source>
        <translation>请检查设备和地址是否正确，串行线路还要检查波特率和帧格式</translation>
    </message>
    <message>
        <source>the board&apos;s description is cut off after {} octets</source>
        <translation>控制板的描述在 {} 个字节后中断</translation>
    </message>
    <message>
        <source>connect again; if it stays so, the board&apos;s firmware holds only half of it and must be updated</source>
        <translation>请重新连接；如果仍然如此，说明控制板固件只含有一半描述，必须更新</translation>
    </message>
    <message>
        <source>the firmware of &apos;{}&apos; changed: it was &apos;{}&apos; at an earlier connection and is &apos;{}&apos; now, so that its description was read anew</source>
        <translation>“{}”的固件已改变：上一次连接时为“{}”，现在为“{}”，因此重新读取了描述</translation>
    </message>
    <message>
        <source>the configuration is of a device of model &apos;{}&apos;, this one is of model &apos;{}&apos;</source>
        <translation>该配置属于型号“{}”的设备，而此设备型号为“{}”</translation>
    </message>
    <message>
        <source>take a file of this model; nothing was written</source>
        <translation>请使用此型号的文件；没有写入任何内容</translation>
    </message>
    <message>
        <source>this device takes it as an order or does not let it be written</source>
        <translation>此设备把它当作命令，或不允许写入</translation>
    </message>
    <message>
        <source>the file has it in &apos;{}&apos;, the device in &apos;{}&apos;</source>
        <translation>文件中的单位是“{}”，设备中是“{}”</translation>
    </message>
    <message>
        <source>this device does not have it</source>
        <translation>此设备没有该项</translation>
    </message>
    <message>
        <source>{}.unit&quot; is &quot;{}&quot;, which is no unit of a value in &quot;{}&quot;</source>
        <translation>{}.unit&quot; 是 &quot;{}&quot;，它不是以 &quot;{}&quot; 计的值的单位</translation>
    </message>
    <message>
        <source>it is a ratio: leave its unit empty</source>
        <translation>这是一个比值：单位留空</translation>
    </message>
    <message>
        <source>write the value in {} or a unit of the same quantity</source>
        <translation>请用 {} 或同一物理量的单位给出该值</translation>
    </message>
    <message>
        <source>{}.unit&quot; must be a text</source>
        <translation>{}.unit&quot; 必须是文本</translation>
    </message>
    <message>
        <source>write &quot;{}&quot;</source>
        <translation>请写 &quot;{}&quot;</translation>
    </message>
    <message>
        <source>the board&apos;s {} may still be {} instead of {} ms, as before it was armed: {}</source>
        <translation>电路板的 {} 可能仍为 {}，而不是启用前的 {} ms：{}</translation>
    </message>
    <message>
        <source>damping is undecided: between zero and {} % of the torque at the lowest frequency</source>
        <translation>阻尼无法确定：在最低频率处介于零与转矩的 {} % 之间</translation>
    </message>
    <message>
        <source>measure from a lower frequency, more periods or with a larger amplitude</source>
        <translation>请从更低的频率开始测量，或增加周期数或幅值</translation>
    </message>
    <message>
        <source>the board&apos;s clock started again: how much time lies before that row is not known</source>
        <translation>电路板的时钟重新开始：该行之前经过了多少时间不得而知</translation>
    </message>
    <message>
        <source>look whether the board was reset; the recording has a gap there</source>
        <translation>请检查电路板是否被复位；记录在该处有间断</translation>
    </message>
    <message>
        <source>the board ran firmware &apos;{}&apos;, but its description was of &apos;{}&apos;: names may have led to wrong values</source>
        <translation>电路板运行固件“{}”，但其描述文件属于“{}”：名称可能指向了错误的值</translation>
    </message>
    <message>
        <source>record it again with the description of this firmware</source>
        <translation>请用该固件的描述文件重新记录</translation>
    </message>
    <message>
        <source>the configuration was read from the device &apos;{}&apos;, this one is &apos;{}&apos;</source>
        <translation>该配置读自设备“{}”，而此设备是“{}”</translation>
    </message>
    <message>
        <source>its calibration was measured there and is left out unless you ask for it</source>
        <translation>其标定是在那台设备上测得的，除非您要求，否则不恢复</translation>
    </message>
    <message>
        <source>the configuration was read from firmware &apos;{}&apos;, this device runs &apos;{}&apos;</source>
        <translation>该配置读自固件“{}”，而此设备运行“{}”</translation>
    </message>
    <message>
        <source>look at each row: a value may mean something else there</source>
        <translation>请逐行查看：某个值在那里可能含义不同</translation>
    </message>
    <message>
        <source>the configuration has no value for &apos;{}&apos;</source>
        <translation>配置中没有“{}”的值</translation>
    </message>
    <message>
        <source>choose among its rows; nothing was written</source>
        <translation>请从其各行中选择；没有写入任何内容</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot be restored: {}</source>
        <translation>无法恢复“{}”：{}</translation>
    </message>
    <message>
        <source>leave it out; nothing was written</source>
        <translation>请去掉它；没有写入任何内容</translation>
    </message>
    <message>
        <source>the actuator is armed; a configuration is not restored then</source>
        <translation>执行器已使能；此时不能恢复配置</translation>
    </message>
    <message>
        <source>disarm it first; nothing was written</source>
        <translation>请先解除使能；没有写入任何内容</translation>
    </message>
    <message>
        <source>the device keeps another value</source>
        <translation>设备保留了另一个值</translation>
    </message>
    <message>
        <source>nothing was written; mend this line or take another file</source>
        <translation>没有写入任何内容；请改正这一行或换一个文件</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was written by a newer Halbench</source>
        <translation>“{}”由更新版本的 Halbench 写入</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is not a configuration; expected &apos;{}&apos;</source>
        <translation>“{}”不是配置；应为“{}”</translation>
    </message>
    <message>
        <source>&apos;device.{}&apos; has no place there</source>
        <translation>“device.{}”不应出现在那里</translation>
    </message>
    <message>
        <source>&apos;{}&apos; stands twice</source>
        <translation>“{}”出现了两次</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a table, [{}]</source>
        <translation>“{}”必须是表，[{}]</translation>
    </message>
    <message>
        <source>&apos;{}&apos; of &apos;{}&apos; is unknown; a row has value and unit</source>
        <translation>“{}”（属于“{}”）未知；一行只有 value 和 unit</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no value</source>
        <translation>“{}”没有值</translation>
    </message>
    <message>
        <source>the value of &apos;{}&apos; must be a finite number</source>
        <translation>“{}”的值必须是有限数</translation>
    </message>
    <message>
        <source>there is no schema = &quot;{}&quot;</source>
        <translation>缺少 schema = &quot;{}&quot;</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;</source>
        <translation>未知键“{}”</translation>
    </message>
    <message>
        <source>&apos;given&apos; must be a table</source>
        <translation>&apos;given&apos; 必须是表</translation>
    </message>
    <message>
        <source>given: {}</source>
        <translation>given：{}</translation>
    </message>
    <message>
        <source>one plateau came to rest and was left out</source>
        <translation>有一个平台停转，已略去</translation>
    </message>
    <message>
        <source>one plateau was too slow to tell friction from creep and was left out</source>
        <translation>有一个平台太慢，无法区分摩擦与爬行，已略去</translation>
    </message>
    <message>
        <source>{} plateaus were too slow to tell friction from creep and were left out</source>
        <translation>有 {} 个平台太慢，无法区分摩擦与爬行，已略去</translation>
    </message>
    <message>
        <source>one plateau was not steady at its end and left out</source>
        <translation>有一个平台结束时未稳定，已略去</translation>
    </message>
    <message>
        <source>{} plateaus were not steady at their end and left out</source>
        <translation>有 {} 个平台结束时未稳定，已略去</translation>
    </message>
    <message>
        <source>one row of the recording was lost</source>
        <translation>记录丢失了一行</translation>
    </message>
    <message>
        <source>{} came back and was lost again {} times in a row</source>
        <translation>{} 恢复后又连续断开 {} 次</translation>
    </message>
    <message>
        <source>another program may be using it, or a plug is loose; then connect again</source>
        <translation>可能有其他程序正在使用它，或插头松动；处理后重新连接</translation>
    </message>
    <message>
        <source>another device answers at {}: {} instead of {}</source>
        <translation>在 {} 应答的是另一台设备：{}，而不是 {}</translation>
    </message>
    <message>
        <source>plug the former one in again, or disconnect and connect this one</source>
        <translation>重新插入原来的设备，或断开后连接这一台</translation>
    </message>
    <message>
        <source>{} came back with other firmware: {} instead of {}</source>
        <translation>{} 恢复后固件不同：{}，而不是 {}</translation>
    </message>
    <message>
        <source>its signals and parameters may be others: disconnect, then connect again</source>
        <translation>其信号和参数可能已改变：请断开后重新连接</translation>
    </message>
    <message>
        <source>no device with the serial number &apos;{}&apos; is plugged in</source>
        <translation>未插入序列号为 &apos;{}&apos; 的设备</translation>
    </message>
    <message>
        <source>plug it in; any port will do</source>
        <translation>请插入设备；任何端口均可</translation>
    </message>
    <message>
        <source>several ports have the serial number &apos;{}&apos;: {} and {}</source>
        <translation>多个端口的序列号为 &apos;{}&apos;：{} 和 {}</translation>
    </message>
    <message>
        <source>name one of them</source>
        <translation>请指定其中一个</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>连接已断开</translation>
    </message>
    <message>
        <source>connection back</source>
        <translation>连接已恢复</translation>
    </message>
    <message>
        <source>the device was changed before anything was written</source>
        <translation>在写入任何内容之前设备已更换</translation>
    </message>
    <message>
        <source>look at the rows again, then restore</source>
        <translation>请再次查看各行，然后恢复</translation>
    </message>
    <message>
        <source>recommended by the program for this motor</source>
        <translation>程序为该电机推荐</translation>
    </message>
    <message>
        <source>device &apos;{}&apos; describes itself and takes no file</source>
        <translation>设备 &apos;{}&apos; 自带描述，不接受文件</translation>
    </message>
    <message>
        <source>name the port of the board first, like tcp:HOST:PORT</source>
        <translation>请先指定控制板的端口，例如 tcp:HOST:PORT</translation>
    </message>
    <message>
        <source>the description &apos;{}&apos; cannot be read: {}</source>
        <translation>无法读取描述文件 &apos;{}&apos;：{}</translation>
    </message>
    <message>
        <source>give the A2L file that belongs to the board&apos;s firmware</source>
        <translation>请给出与控制板固件对应的 A2L 文件</translation>
    </message>
    <message>
        <source>the description &apos;{}&apos; has {} octets</source>
        <translation>描述文件 &apos;{}&apos; 有 {} 个字节</translation>
    </message>
    <message>
        <source>known are baud, dtr, low_latency, framing, header, checksum, sync, escape, a2l</source>
        <translation>已知的有 baud、dtr、low_latency、framing、header、checksum、sync、escape、a2l</translation>
    </message>
    <message>
        <source>a {}: address has no option but a2l</source>
        <translation>{}：地址除 a2l 外没有其他选项</translation>
    </message>
    <message>
        <source>no udev runs here, so that rules have no effect: allow it with &apos;sudo chmod a+rw {}&apos; each time it was plugged in</source>
        <translation>此处没有运行 udev，规则不起作用：每次插上后请用 &apos;sudo chmod a+rw {}&apos; 允许访问</translation>
    </message>
    <message>
        <source>the parameters of &apos;{}&apos; can only be read: the board runs on a page of it that takes no writes</source>
        <translation>&apos;{}&apos; 的参数只能读取：控制板正运行在其不接受写入的页上</translation>
    </message>
    <message>
        <source>parameter &apos;{}&apos; is left out: {}</source>
        <translation>参数 &apos;{}&apos; 被略去：{}</translation>
    </message>
    <message>
        <source>this board does not say whether it stopped: use the switch at the actuator</source>
        <translation>此控制板不说明是否已停止：请使用执行器上的开关</translation>
    </message>
    <message>
        <source>give the A2L file that belongs to it: DEVICE?a2l=FILE</source>
        <translation>请给出其 A2L 文件：设备?a2l=文件</translation>
    </message>
    <message>
        <source>time does not rise from row {} to row {}</source>
        <translation>第 {} 行到第 {} 行的时间没有增加</translation>
    </message>
    <message>
        <source>a spectrum needs rows in the order of time</source>
        <translation>频谱需要按时间顺序排列的行</translation>
    </message>
    <message>
        <source>the rows are not evenly spaced: {} s before row {} where {} s are usual</source>
        <translation>各行间隔不均匀：{} s（第 {} 行之前），通常为 {} s</translation>
    </message>
    <message>
        <source>a spectrum needs a signal that was sampled at a constant rate; resample it first</source>
        <translation>频谱需要以恒定速率采样的信号；请先重新采样</translation>
    </message>
    <message>
        <source>{} rows have no rate</source>
        <translation>{} 行没有速率</translation>
    </message>
    <message>
        <source>a spectrum needs a recording with more rows</source>
        <translation>频谱需要行数更多的记录</translation>
    </message>
    <message>
        <source>overlap, confidence and segment must be finite numbers</source>
        <translation>重叠、置信度和分段必须是有限数</translation>
    </message>
    <message>
        <source>an overlap of {} is not possible</source>
        <translation>重叠不能为 {}</translation>
    </message>
    <message>
        <source>give a ratio from 0 to 0.95; 0.5 is usual, 0.75 for flat-top and blackman-harris</source>
        <translation>请给出 0 到 0.95 的比值；通常为 0.5，flat-top 和 blackman-harris 为 0.75</translation>
    </message>
    <message>
        <source>a confidence of {} is not between 0 and 1</source>
        <translation>置信度 {} 不在 0 与 1 之间</translation>
    </message>
    <message>
        <source>0.95 is usual</source>
        <translation>通常为 0.95</translation>
    </message>
    <message>
        <source>no {} rows follow each other without a gap or missing value</source>
        <translation>没有连续 {} 行不含缺口或缺失值</translation>
    </message>
    <message>
        <source>record longer, or at a rate that the link carries without losses</source>
        <translation>请记录更长时间，或使用连接不会丢失数据的速率</translation>
    </message>
    <message>
        <source>a segment of {} s has fewer than {} rows</source>
        <translation>{} s 的分段少于 {} 行</translation>
    </message>
    <message>
        <source>give at least {} s</source>
        <translation>请至少给出 {} s</translation>
    </message>
    <message>
        <source>a segment of {} s does not fit: the longest stretch without a gap or missing value has {} rows, {} s</source>
        <translation>{} s 的分段放不下：不含缺口或缺失值的最长区间为 {} 行，{} s</translation>
    </message>
    <message>
        <source>give a shorter segment, or record longer</source>
        <translation>请给出更短的分段，或记录更长时间</translation>
    </message>
    <message>
        <source>the rate is not constant: {} rows from {} s on take {} s where {} s are the average</source>
        <translation>速率不恒定：{} 行（自 {} s 起）用时 {} s，平均为 {} s</translation>
    </message>
    <message>
        <source>give a shorter segment, or a part of the recording with one rate</source>
        <translation>请给出更短的分段，或选取记录中速率单一的部分</translation>
    </message>
    <message>
        <source>{} segments of {} lines are too many values for a spectrogram</source>
        <translation>{} 个分段、每段 {} 条谱线，对频谱图来说数据过多</translation>
    </message>
    <message>
        <source>let the segments overlap less, or take a part of the recording</source>
        <translation>请减小分段重叠，或选取记录的一部分</translation>
    </message>
    <message>
        <source>this version reads .csv, .mf4 and .csv.partial (an interrupted recording)</source>
        <translation>此版本读取 .csv、.mf4 和 .csv.partial（中断的记录）</translation>
    </message>
    <message>
        <source>line {}: {}</source>
        <translation>第 {} 行：{}</translation>
    </message>
    <message>
        <source>recording of {} {}</source>
        <translation>{} {} 的记录</translation>
    </message>
    <message>
        <source>written by Halbench</source>
        <translation>由 Halbench 写入</translation>
    </message>
    <message>
        <source>Halbench maintainers</source>
        <translation>Halbench 维护者</translation>
    </message>
    <message>
        <source>a parameter was changed</source>
        <translation>参数已更改</translation>
    </message>
    <message>
        <source>the file is damaged or another program wrote it; let that program export CSV</source>
        <translation>文件已损坏或由其他程序写入；请用该程序导出 CSV</translation>
    </message>
    <message>
        <source>{}: block {} at octet {}: {}</source>
        <translation>{}：块 {}，位于字节 {}：{}</translation>
    </message>
    <message>
        <source>it is not inside the file</source>
        <translation>它不在文件之内</translation>
    </message>
    <message>
        <source>another block is there</source>
        <translation>该处是另一个块</translation>
    </message>
    <message>
        <source>its length {} cannot be</source>
        <translation>其长度 {} 不可能</translation>
    </message>
    <message>
        <source>it has other links</source>
        <translation>它的链接数不同</translation>
    </message>
    <message>
        <source>it is linked more than once</source>
        <translation>它被链接了不止一次</translation>
    </message>
    <message>
        <source>this is no MDF file</source>
        <translation>这不是 MDF 文件</translation>
    </message>
    <message>
        <source>give a file that begins with &quot;MDF&quot;</source>
        <translation>请给出以 &quot;MDF&quot; 开头的文件</translation>
    </message>
    <message>
        <source>the file is not finalised</source>
        <translation>文件未完成</translation>
    </message>
    <message>
        <source>its writing was interrupted; write it again</source>
        <translation>写入被中断；请重新写入</translation>
    </message>
    <message>
        <source>version {}</source>
        <translation>版本 {}</translation>
    </message>
    <message>
        <source>only version 410 is read</source>
        <translation>只读取版本 410</translation>
    </message>
    <message>
        <source>another program wrote the file</source>
        <translation>文件由其他程序写入</translation>
    </message>
    <message>
        <source>only MDF4 files of Halbench are read; let that program export CSV</source>
        <translation>只读取 Halbench 的 MDF4 文件；请用该程序导出 CSV</translation>
    </message>
    <message>
        <source>the file is not sorted or has several groups</source>
        <translation>文件未排序或含有多个组</translation>
    </message>
    <message>
        <source>it has flags, invalidation bits or a neighbour</source>
        <translation>它带有标志、无效位或相邻块</translation>
    </message>
    <message>
        <source>no signal can have this name</source>
        <translation>信号不能使用此名称</translation>
    </message>
    <message>
        <source>it is of another kind than time and 64-bit floats</source>
        <translation>它的类型不是时间和 64 位浮点数</translation>
    </message>
    <message>
        <source>its rows do not hold its channels</source>
        <translation>其行与其通道不符</translation>
    </message>
    <message>
        <source>its time or its neighbour cannot be</source>
        <translation>其时间或相邻块不可能</translation>
    </message>
    <message>
        <source>its length is not that of {} rows</source>
        <translation>其长度与 {} 行不符</translation>
    </message>
    <message>
        <source>row {}: the time does not increase</source>
        <translation>第 {} 行：时间没有递增</translation>
    </message>
    <message>
        <source>the board runs firmware &apos;{}&apos;, but its description is of &apos;{}&apos;: names may lead to wrong values, so nothing is written; give the description of this firmware, or update the board&apos;s firmware as a whole</source>
        <translation>控制板运行固件“{}”，但其描述属于“{}”：名称可能指向错误的值，因此不写入任何内容；请提供该固件的描述，或整体更新控制板固件</translation>
    </message>
    <message>
        <source>nothing is written: the description is not of the firmware that the board runs</source>
        <translation>未写入任何内容：该描述不属于控制板正在运行的固件</translation>
    </message>
    <message>
        <source>give the description of this firmware, or update the board&apos;s firmware as a whole</source>
        <translation>请提供该固件的描述，或整体更新控制板固件</translation>
    </message>
    <message>
        <source>{}: another program works with this board</source>
        <translation>{}：另一个程序正在使用此控制板</translation>
    </message>
    <message>
        <source>end that program&apos;s connection, then connect again; one that has gone silent is given up after a few seconds</source>
        <translation>请结束该程序的连接，然后重新连接；已无响应的程序会在几秒后被放弃</translation>
    </message>
    <message>
        <source>this version writes .csv, .mf4 and .mat</source>
        <translation>此版本写入 .csv、.mf4 和 .mat</translation>
    </message>
    <message>
        <source>MATLAB 5.0 MAT-file, written by Halbench</source>
        <translation>MATLAB 5.0 MAT 文件，由 Halbench 写入</translation>
    </message>
    <message>
        <source>cannot write &apos;{}&apos;: it is not complete</source>
        <translation>无法写入“{}”：文件不完整</translation>
    </message>
    <message>
        <source>at most {} are read; write it in parts, with --from and --to</source>
        <translation>最多读取 {}；请用 --from 和 --to 分段写入</translation>
    </message>
    <message>
        <source>give a finite number</source>
        <translation>请给出有限数</translation>
    </message>
    <message>
        <source>a trigger without a source</source>
        <translation>触发没有信号源</translation>
    </message>
    <message>
        <source>give the name of a signal</source>
        <translation>请给出信号名称</translation>
    </message>
    <message>
        <source>level, hysteresis and times of a trigger must be finite numbers</source>
        <translation>触发的电平、迟滞和时间必须是有限数</translation>
    </message>
    <message>
        <source>a hysteresis of {} is negative</source>
        <translation>迟滞 {} 为负</translation>
    </message>
    <message>
        <source>give 0 or how far the signal must have been on the other side of the level</source>
        <translation>请给出 0，或信号须在电平另一侧达到的距离</translation>
    </message>
    <message>
        <source>a pre-trigger share of {} is not between 0 and 1</source>
        <translation>预触发比例 {} 不在 0 与 1 之间</translation>
    </message>
    <message>
        <source>0.25 shows a quarter of the window before the trigger</source>
        <translation>0.25 表示窗口的四分之一在触发之前</translation>
    </message>
    <message>
        <source>a trigger&apos;s window of {} s, hold-off of {} s and longest wait of {} s are not possible</source>
        <translation>触发窗口 {} s、释抑 {} s 和最长等待 {} s 不可行</translation>
    </message>
    <message>
        <source>the window and the wait are longer than 0, the hold-off is not negative</source>
        <translation>窗口和等待须大于 0，释抑不能为负</translation>
    </message>
    <message>
        <source>correct the line; the forms are in resources/help/projects.md and command-line.md</source>
        <translation>请改正该行；格式见 resources/help/projects.md 和 command-line.md</translation>
    </message>
    <message>
        <source>the board neither tells its firmware nor shows the octets where its description keeps it: whether the two belong together is not known</source>
        <translation>控制板既不报告其固件，也不允许读取描述文件所指的固件标识字节：无法确认两者是否匹配</translation>
    </message>
    <message>
        <source>the Nyquist curve runs through -1: the loop is on the limit of stability</source>
        <translation>奈奎斯特曲线经过 -1：回路处于稳定极限</translation>
    </message>
    <message>
        <source>change the gain a little</source>
        <translation>请稍微改变增益</translation>
    </message>
    <message>
        <source>behind a dead time this loop does not fall below 1 at high frequency</source>
        <translation>带纯滞后的该回路在高频处不会降到 1 以下</translation>
    </message>
    <message>
        <source>the dead time is not a finite number</source>
        <translation>纯滞后时间不是有限数</translation>
    </message>
    <message>
        <source>a dead time of {} s is not possible</source>
        <translation>{} s 的纯滞后时间不可能</translation>
    </message>
    <message>
        <source>a system with {} s of dead time cannot be added to one with {} s</source>
        <translation>纯滞后为 {} s 的系统不能与纯滞后为 {} s 的系统相加</translation>
    </message>
    <message>
        <source>discretize both, or approximate their dead times, first</source>
        <translation>请先将二者离散化，或近似其纯滞后</translation>
    </message>
    <message>
        <source>{} rows dropped: the disk did not keep up</source>
        <translation>丢弃了 {} 行：磁盘跟不上</translation>
    </message>
    <message>
        <source>Stable, if what is assumed here is true:</source>
        <translation>稳定，前提是以下假设成立：</translation>
    </message>
    <message>
        <source>Good: robustly stable</source>
        <translation>良好：鲁棒稳定</translation>
    </message>
    <message>
        <source>Good: stable</source>
        <translation>良好：稳定</translation>
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
        <source>identify this device and tune with that model</source>
        <translation>请辨识此设备，并用该模型整定</translation>
    </message>
    <message>
        <source>the model was identified on the {} &apos;{}&apos;, this device is the {} &apos;{}&apos;</source>
        <translation>该模型是在 {} “{}”上辨识的，而此设备是 {} “{}”</translation>
    </message>
    <message>
        <source>the model was identified on &apos;{}&apos; with other overrides than this device has</source>
        <translation>该模型是在“{}”上以不同的覆盖参数辨识的</translation>
    </message>
    <message>
        <source>{} MB from the board waited and nobody took them</source>
        <translation>控制板发来的 {} MB 数据一直在等待，无人读取</translation>
    </message>
    <message>
        <source>the computer was too busy or asleep: connect again, with fewer signals or a lower rate</source>
        <translation>计算机过于繁忙或处于休眠：请重新连接，并减少信号或降低采样率</translation>
    </message>
    <message>
        <source>it is the console of this machine</source>
        <translation>它是本机的控制台</translation>
    </message>
    <message>
        <source>take another port, or start the machine without &apos;console=&apos; for this one</source>
        <translation>请使用其他端口，或在启动本机时不为此端口设置 &apos;console=&apos;</translation>
    </message>
    <message>
        <source>load it: sudo modprobe {}</source>
        <translation>加载驱动：sudo modprobe {}</translation>
    </message>
    <message>
        <source>held by the kernel driver &apos;{}&apos;</source>
        <translation>被内核驱动 &apos;{}&apos; 占用</translation>
    </message>
    <message>
        <source>if it is the board, connect to {}: the driver is detached until you disconnect</source>
        <translation>若它是控制板，请连接 {}：断开之前驱动会被暂时解除</translation>
    </message>
    <message>
        <source>{}: the system has no memory left for USB transfers</source>
        <translation>{}：系统没有更多内存用于 USB 传输</translation>
    </message>
    <message>
        <source>close other programs that use USB, or raise /sys/module/usbcore/parameters/usbfs_memory_mb</source>
        <translation>请关闭其他使用 USB 的程序，或增大 /sys/module/usbcore/parameters/usbfs_memory_mb</translation>
    </message>
    <message>
        <source>the transfer failed</source>
        <translation>传输失败</translation>
    </message>
    <message>
        <source>{}: the kernel driver &apos;{}&apos; does not let go of it: {}</source>
        <translation>{}：内核驱动 &apos;{}&apos; 不肯释放它：{}</translation>
    </message>
    <message>
        <source>unload the driver: sudo modprobe -r {}</source>
        <translation>卸载驱动：sudo modprobe -r {}</translation>
    </message>
    <message>
        <source>the board sent more than was asked for</source>
        <translation>控制板发送的数据超出了请求的数量</translation>
    </message>
    <message>
        <source>{}; whether it has begun is not known, so it was ended</source>
        <translation>{}；是否已经开始无从得知，因此已将其结束</translation>
    </message>
    <message>
        <source>see where the actuator stands, then start again; newer firmware of this board takes a lost answer without harm</source>
        <translation>请查看执行器的位置，然后重新启动；该控制板的新固件可以承受应答丢失</translation>
    </message>
    <message>
        <source>See where the rotor stands and that no other program uses the board, then move again.</source>
        <translation>请查看转子的位置，确认没有其他程序在使用控制板，然后重新运动。</translation>
    </message>
    <message>
        <source>See that no other program uses the board, then move again.</source>
        <translation>请确认没有其他程序在使用控制板，然后重新运动。</translation>
    </message>
    <message>
        <source>the rotor ended at {} instead of {} degrees</source>
        <translation>转子停在 {} 度，而不是 {} 度</translation>
    </message>
    <message>
        <source>axis {} ended at {} instead of {} {}</source>
        <translation>轴 {} 停在 {}，而不是 {} {}</translation>
    </message>
    <message>
        <source>Move for longer; check the gains and that nothing blocks the rotor.</source>
        <translation>请延长运动时间；检查增益，并确认没有东西卡住转子。</translation>
    </message>
    <message>
        <source>Move for longer; check the gains and that nothing is in the way.</source>
        <translation>请延长运动时间；检查增益，并确认没有障碍物。</translation>
    </message>
    <message>
        <source>a move of {} {} leaves the window of {} {} of axis {}</source>
        <translation>移动 {} {} 会超出 {} {} 的窗口（轴 {}）</translation>
    </message>
    <message>
        <source>Move less, or set {} on the device. Nothing was armed.</source>
        <translation>请减小移动量，或在设备上设置 {}。未使能任何输出。</translation>
    </message>
    <message>
        <source>the limit or level of a nonlinear element must be positive, its hysteresis not negative</source>
        <translation>非线性环节的限值或幅度必须为正，其滞环不得为负</translation>
    </message>
    <message>
        <source>a root locus needs a loop with poles and a gain</source>
        <translation>根轨迹需要一个具有极点和增益的回路</translation>
    </message>
    <message>
        <source>the largest gain of a root locus, {}, is not positive</source>
        <translation>根轨迹的最大增益 {} 不是正数</translation>
    </message>
    <message>
        <source>the impulse response of this system begins with an impulse</source>
        <translation>该系统的脉冲响应以一个脉冲开始</translation>
    </message>
    <message>
        <source>choose another rule, or add the filter that every real system has</source>
        <translation>请选择其他规则，或加入每个真实系统都有的滤波器</translation>
    </message>
    <message>
        <source>this sampled system is not the image of a continuous one</source>
        <translation>该采样系统不是连续系统的映像</translation>
    </message>
    <message>
        <source>a pole lies at zero or on the negative real axis: choose Tustin, or take delays out first</source>
        <translation>有极点位于零点或负实轴：请选择 Tustin，或先去除延迟</translation>
    </message>
    <message>
        <source>poles and zeros can only be matched for one input and one output</source>
        <translation>只有单输入单输出时才能匹配零极点</translation>
    </message>
    <message>
        <source>the system is already continuous</source>
        <translation>系统已经是连续的</translation>
    </message>
    <message>
        <source>a response needs a system with one input and one output</source>
        <translation>响应需要单输入单输出系统</translation>
    </message>
    <message>
        <source>a response needs ascending times, each with its input</source>
        <translation>响应需要递增的时间，且每个时间都有输入</translation>
    </message>
    <message>
        <source>systems with {} and {} signals cannot be connected</source>
        <translation>具有 {} 个和 {} 个信号的系统不能相连</translation>
    </message>
    <message>
        <source>a zero, a pole or the gain of a system is not a finite number</source>
        <translation>系统的某个零点、极点或增益不是有限数</translation>
    </message>
    <message>
        <source>a complex zero or pole lacks its conjugate partner</source>
        <translation>某个复数零点或极点缺少其共轭</translation>
    </message>
    <message>
        <source>a figure of the filter is not a finite number</source>
        <translation>滤波器的某个参数不是有限数</translation>
    </message>
    <message>
        <source>this filter is not possible: {} lies outside its range</source>
        <translation>该滤波器不可能：{} 超出其范围</translation>
    </message>
    <message>
        <source>the targets of this design are not possible: they must be positive, Ms above 1</source>
        <translation>该设计的目标不可能：它们必须为正，且 Ms 大于 1</translation>
    </message>
    <message>
        <source>the design is unstable in the sampled loop</source>
        <translation>该设计在采样回路中不稳定</translation>
    </message>
    <message>
        <source>ask for less speed, or shorten the computing delay</source>
        <translation>请降低速度要求，或缩短计算延迟</translation>
    </message>
    <message>
        <source>allow a larger Ms, or shorten the computing delay</source>
        <translation>请允许更大的 Ms，或缩短计算延迟</translation>
    </message>
    <message>
        <source>the current limit must be positive</source>
        <translation>电流限值必须为正</translation>
    </message>
    <message>
        <source>the weights of the regulator do not fit the system</source>
        <translation>调节器的权重与系统不符</translation>
    </message>
    <message>
        <source>no regulator stabilises this system with these weights</source>
        <translation>采用这些权重没有调节器能使该系统稳定</translation>
    </message>
    <message>
        <source>weigh every state that does not come to rest by itself</source>
        <translation>请对每个不会自行静止的状态加权</translation>
    </message>
    <message>
        <source>a constant of the process model is not a finite number</source>
        <translation>过程模型的某个常数不是有限数</translation>
    </message>
    <message>
        <source>this tuning rule needs a process with a gain and a lag, and a time to close in</source>
        <translation>该整定规则需要具有增益和滞后的过程，以及闭环时间</translation>
    </message>
    <message>
        <source>this process never swings under proportional control: it has no ultimate gain</source>
        <translation>该过程在比例控制下从不振荡：没有临界增益</translation>
    </message>
    <message>
        <source>use SIMC or pole placement</source>
        <translation>请使用 SIMC 或极点配置</translation>
    </message>
    <message>
        <source>a relay experiment needs a level, a period and a swing beyond its hysteresis</source>
        <translation>继电实验需要幅度、周期以及超出滞环的摆幅</translation>
    </message>
    <message>
        <source>none of the drawn plants is a motor</source>
        <translation>抽取的对象中没有一个是电机</translation>
    </message>
    <message>
        <source>must be &apos;{}&apos;, &apos;{}&apos; or &apos;{}&apos;</source>
        <translation>必须是 &apos;{}&apos;、&apos;{}&apos; 或 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>&apos;trigger&apos; must be a table, [monitor.trigger]</source>
        <translation>&apos;trigger&apos; 必须是表，[monitor.trigger]</translation>
    </message>
    <message>
        <source>of a trigger window_s is more than 0, hysteresis and hold_off_s are not negative, pre_trigger_ratio is from 0 to 1</source>
        <translation>触发的 window_s 大于 0，hysteresis 和 hold_off_s 不为负，pre_trigger_ratio 在 0 到 1 之间</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be true or false</source>
        <translation>&apos;{}&apos; 必须是 true 或 false</translation>
    </message>
    <message>
        <source>0 stops, 1 starts the generator, 2 to 255 start it once</source>
        <translation>0 停止，1 启动信号发生器，2 到 255 只启动一次</translation>
    </message>
    <message>
        <source>0 stops, 1 starts the capture, 2 to 255 start it once</source>
        <translation>0 停止，1 启动采集，2 到 255 只启动一次</translation>
    </message>
    <message>
        <source>whether it is released is not known</source>
        <translation>是否已解除停止尚不清楚</translation>
    </message>
    <message>
        <source>it is still stopped: {}</source>
        <translation>它仍处于停止状态：{}</translation>
    </message>
    <message>
        <source>this system may keep no more than {} ms of this stream while the program is busy; what comes then is lost: raise its limit (sysctl net.core.rmem_max={}), take fewer signals or a lower rate, or connect by tcp:</source>
        <translation>程序忙碌时，本系统可能只能保留此数据流的 {} ms，之后到达的数据会丢失：请提高系统上限（sysctl net.core.rmem_max={}），减少信号或降低采样率，或改用 tcp: 连接</translation>
    </message>
    <message>
        <source>the law on the board has no stage for a {} filter</source>
        <translation>控制板上的控制律没有 {} 滤波环节</translation>
    </message>
    <message>
        <source>a resonance or noise is avoided by a lower crossover: method bandwidth, or lead</source>
        <translation>可用较低的穿越频率避开谐振或噪声：方法 bandwidth 或 lead</translation>
    </message>
    <message>
        <source>SIMC, the internal-model rule of Skogestad, for lag and dead time</source>
        <translation>SIMC，Skogestad 的内模整定规则，适用于滞后加死区时间</translation>
    </message>
    <message>
        <source>lambda tuning: the closed loop is a lag of the asked bandwidth, twice</source>
        <translation>lambda 整定：闭环为两个具有所要求带宽的滞后环节</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, PID, from where the loop swings; a lively starting point</source>
        <translation>Ziegler-Nichols，PID，从回路的临界振荡点出发；一个较活跃的起点</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, PI, from where the loop swings</source>
        <translation>Ziegler-Nichols，PI，从回路的临界振荡点出发</translation>
    </message>
    <message>
        <source>Ziegler and Nichols, P: half of the gain at which the loop swings</source>
        <translation>Ziegler-Nichols，P：临界振荡增益的一半</translation>
    </message>
    <message>
        <source>linear-quadratic regulator, error and current weighed for the asked frequency</source>
        <translation>线性二次型调节器，误差与电流按所要求的频率加权</translation>
    </message>
    <message>
        <source>the same with the error weighed by time: what lasts is punished</source>
        <translation>同上，误差按时间加权：持续的误差受到惩罚</translation>
    </message>
    <message>
        <source>PD, the lead of the board, with the asked phase margin</source>
        <translation>PD，控制板的超前环节，具有所要求的相位裕度</translation>
    </message>
    <message>
        <source>PI, the lag of the board, through the asked crossover</source>
        <translation>PI，控制板的滞后环节，通过所要求的穿越频率</translation>
    </message>
    <message>
        <source>the law on the board has no filter on its derivative, these gains have one of {} s</source>
        <translation>控制板上的控制律没有微分滤波，而这组增益带有 {} s 的滤波</translation>
    </message>
    <message>
        <source>leave the filter out (filter_s null): the board takes the difference over one sample; where its noise is too much, lower K_D</source>
        <translation>请去掉滤波（filter_s 为 null）：控制板取一个采样周期的差分；若噪声过大，请降低 K_D</translation>
    </message>
    <message>
        <source>the gains of this rule, K_P = {} A/rad, K_I = {} A/(rad s) and K_D = {} A s/rad, are unstable in the sampled loop: pole radius {}</source>
        <translation>该规则给出的增益 K_P = {} A/rad、K_I = {} A/(rad s)、K_D = {} A s/rad 在采样回路中不稳定：极点半径 {}</translation>
    </message>
    <message>
        <source>this rule needs a motor that damps: its model has c/J = 0</source>
        <translation>该规则需要有阻尼的电机：其模型 c/J = 0</translation>
    </message>
    <message>
        <source>use method bandwidth, phase-margin or lqr</source>
        <translation>请使用方法 bandwidth、phase-margin 或 lqr</translation>
    </message>
    <message>
        <source>ask for a lower bandwidth</source>
        <translation>请要求较低的带宽</translation>
    </message>
    <message>
        <source>this rule leaves little damping: use method recommended, bandwidth or phase-margin</source>
        <translation>该规则留下的阻尼很小：请使用方法 recommended、bandwidth 或 phase-margin</translation>
    </message>
    <message>
        <source>ask for a lower crossover, or use method lead or phase-margin</source>
        <translation>请要求较低的穿越频率，或使用方法 lead 或 phase-margin</translation>
    </message>
    <message>
        <source>a design needs a name</source>
        <translation>设计需要一个名称</translation>
    </message>
    <message>
        <source>there is a design &apos;{}&apos; already</source>
        <translation>已有设计“{}”</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>请选择其他名称</translation>
    </message>
    <message>
        <source>one more sample of delay makes this loop unstable: its delay margin is {} ms</source>
        <translation>再多一个采样的延迟就会使该回路不稳定：其时延裕度为 {} ms</translation>
    </message>
    <message>
        <source>make sure that the delay is known (delay.samples), or choose a slower loop</source>
        <translation>请确保延迟已知（delay.samples），或选择较慢的回路</translation>
    </message>
    <message>
        <source>the excited rows are not whole periods of three signals</source>
        <translation>被激励的各行不是三个信号的整周期</translation>
    </message>
    <message>
        <source>{} periods say too little of the scatter</source>
        <translation>{} 个周期不足以说明离散程度</translation>
    </message>
    <message>
        <source>measure at least {}</source>
        <translation>至少测量 {} 个</translation>
    </message>
    <message>
        <source>the excited lines do not ascend below half the rate</source>
        <translation>被激励的谱线没有递增，或超过采样率的一半</translation>
    </message>
    <message>
        <source>an excited row holds no number</source>
        <translation>被激励的某一行不是数字</translation>
    </message>
    <message>
        <source>the excitation did not reach the plant</source>
        <translation>激励没有到达被控对象</translation>
    </message>
    <message>
        <source>check that the reference generator ran</source>
        <translation>检查参考发生器是否运行</translation>
    </message>
    <message>
        <source>too few usable frequencies for a fit of the rotor</source>
        <translation>可用频率太少，无法拟合转子</translation>
    </message>
    <message>
        <source>measure more frequencies, or with more excitation</source>
        <translation>测量更多频率，或加大激励</translation>
    </message>
    <message>
        <source>the measured response is not that of a rotor</source>
        <translation>测得的频率响应不是转子的响应</translation>
    </message>
    <message>
        <source>look at its points; an angle error or a resonance may be in it</source>
        <translation>查看各点；其中可能有角度误差或谐振</translation>
    </message>
    <message>
        <source>rows are missing near {} Hz: the periods do not fit together</source>
        <translation>{} Hz 附近缺少数据行：各周期无法衔接</translation>
    </message>
    <message>
        <source>no phase margin: the loop crosses nowhere on the frequencies that are used</source>
        <translation>没有相位裕度：在所用频率上开环没有穿越</translation>
    </message>
    <message>
        <source>no phase margin: the loop crosses where frequencies were left out or are far apart</source>
        <translation>没有相位裕度：穿越处的频率被剔除或相距太远</translation>
    </message>
    <message>
        <source>no phase margin: it lies between {} and {} deg, known to {} at best</source>
        <translation>没有相位裕度：它在 {} 与 {} 度之间，最多只知道到 {}</translation>
    </message>
    <message>
        <source>{} deg are allowed: measure more periods, and calibrate the sensors&apos; gain and the stray field first</source>
        <translation>允许 {} 度：测量更多周期，并先校准传感器增益和杂散磁场</translation>
    </message>
    <message>
        <source>no gain margin: the loop crosses nowhere on the frequencies that are used</source>
        <translation>没有增益裕度：在所用频率上开环没有穿越</translation>
    </message>
    <message>
        <source>no gain margin: the loop crosses where frequencies were left out or are far apart</source>
        <translation>没有增益裕度：穿越处的频率被剔除或相距太远</translation>
    </message>
    <message>
        <source>no gain margin: it lies between {} and {} dB, known to {} at best</source>
        <translation>没有增益裕度：它在 {} 与 {} dB 之间，最多只知道到 {}</translation>
    </message>
    <message>
        <source>{} dB are allowed: measure more periods, and calibrate the sensors&apos; gain and the stray field first</source>
        <translation>允许 {} dB：测量更多周期，并先校准传感器增益和杂散磁场</translation>
    </message>
    <message>
        <source>measure up to a higher, or from a lower frequency</source>
        <translation>测到更高频率，或从更低频率开始</translation>
    </message>
    <message>
        <source>measure with more periods or a larger amplitude there</source>
        <translation>在该处用更多周期或更大幅值测量</translation>
    </message>
    <message>
        <source>{} of {} frequencies have a coherence below {} and were left out</source>
        <translation>{}/{} 个频率的相干性低于 {}，已剔除</translation>
    </message>
    <message>
        <source>measure more periods or with a larger amplitude</source>
        <translation>测量更多周期或加大幅值</translation>
    </message>
    <message>
        <source>the current reached its limit of {} A: the plant is right, the closed loop was not linear</source>
        <translation>电流达到限值 {} A：被控对象正确，但闭环不是线性的</translation>
    </message>
    <message>
        <source>use a smaller amplitude</source>
        <translation>使用更小的幅值</translation>
    </message>
    <message>
        <source>the stray field was compensated for the measurement; on the board it is not</source>
        <translation>测量时补偿了杂散磁场；控制板上没有补偿</translation>
    </message>
    <message>
        <source>switch stray.enabled on: the loop that was measured is the one with it</source>
        <translation>打开 stray.enabled：测量的是带补偿的回路</translation>
    </message>
    <message>
        <source>the points do not decide the constants of a rotor</source>
        <translation>这些点不能确定转子的常数</translation>
    </message>
    <message>
        <source>measure more frequencies, from 0.5 Hz or lower</source>
        <translation>从 0.5 Hz 或更低开始测量更多频率</translation>
    </message>
    <message>
        <source>the points lie {} times farther from the fitted rotor than they scatter</source>
        <translation>各点偏离拟合转子的距离是其离散程度的 {} 倍</translation>
    </message>
    <message>
        <source>its intervals are widened by that; look for a resonance or an angle error that turns with it</source>
        <translation>区间已相应放宽；检查是否有谐振或随转子旋转的角度误差</translation>
    </message>
    <message>
        <source>allowed: {} to {}</source>
        <translation>允许：{} 至 {}</translation>
    </message>
    <message>
        <source>lowest frequency in Hz</source>
        <translation>最低频率（Hz）</translation>
    </message>
    <message>
        <source>highest frequency in Hz</source>
        <translation>最高频率（Hz）</translation>
    </message>
    <message>
        <source>number of periods</source>
        <translation>周期数</translation>
    </message>
    <message>
        <source>least coherence</source>
        <translation>最小相干性</translation>
    </message>
    <message>
        <source>amplitude in rad</source>
        <translation>幅值（rad）</translation>
    </message>
    <message>
        <source>a base speed of {} rad/s is too slow: friction is a plain offset only while the rotor turns</source>
        <translation>{} rad/s 的基础转速太慢：只有转子转动时摩擦才是单纯的偏置</translation>
    </message>
    <message>
        <source>use at least {} rad/s in either direction</source>
        <translation>任一方向至少使用 {} rad/s</translation>
    </message>
    <message>
        <source>base speed in rad/s</source>
        <translation>基础转速（rad/s）</translation>
    </message>
    <message>
        <source>an amplitude of {} deg swings the reference&apos;s speed by {} rad/s on a base of {} rad/s: the total would change its sign and friction would be no offset</source>
        <translation>{} 度的幅值使参考转速摆动 {} rad/s，而基础转速为 {} rad/s：总转速会变号，摩擦就不再是偏置</translation>
    </message>
    <message>
        <source>use at most {} deg, a faster base, fewer high frequencies, or leave the amplitude to the program</source>
        <translation>最多使用 {} 度、更快的基础转速、更少的高频，或让程序决定幅值</translation>
    </message>
    <message>
        <source>the rotor came down to {} rad/s on a base of {} rad/s: near standstill friction is no plain offset</source>
        <translation>转子降到 {} rad/s，而基础转速为 {} rad/s：接近静止时摩擦不是单纯的偏置</translation>
    </message>
    <message>
        <source>use a smaller amplitude or a faster base; a loop that swings by itself needs gains with more damping first</source>
        <translation>使用更小的幅值或更快的基础转速；自行振荡的回路需先换用阻尼更大的增益</translation>
    </message>
    <message>
        <source>runs up</source>
        <translation>正在加速</translation>
    </message>
    <message>
        <source>excites from {} Hz</source>
        <translation>从 {} Hz 起激励</translation>
    </message>
    <message>
        <source>the board runs the printed difference equation, which is no set of gains</source>
        <translation>控制板运行的是印刷的差分方程，它不是一组增益</translation>
    </message>
    <message>
        <source>set control.law=0 first; nothing was armed</source>
        <translation>先设置 control.law=0；未使能任何设备</translation>
    </message>
    <message>
        <source>use a stepped sine</source>
        <translation>使用步进正弦</translation>
    </message>
    <message>
        <source>there is no excitation &apos;{}&apos;</source>
        <translation>没有激励“{}”</translation>
    </message>
    <message>
        <source>known: {}</source>
        <translation>已知：{}</translation>
    </message>
    <message>
        <source>a frequency response needs a board with a position loop of its own</source>
        <translation>频率响应需要自带位置环的控制板</translation>
    </message>
    <message>
        <source>the name &apos;{}&apos; is taken</source>
        <translation>名称 &apos;{}&apos; 已被占用</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no name of a signal</source>
        <translation>&apos;{}&apos; 不是信号名称</translation>
    </message>
    <message>
        <source>letters, digits, dots and underscores; it does not begin with a digit or a dot</source>
        <translation>字母、数字、点和下划线；不以数字或点开头</translation>
    </message>
    <message>
        <source>the expression names no signal</source>
        <translation>表达式中没有信号</translation>
    </message>
    <message>
        <source>write names of signals as recordings have them, e.g. current.a</source>
        <translation>请按录制文件中的写法写信号名，例如 current.a</translation>
    </message>
    <message>
        <source>column {} of the expression: there is no signal &apos;{}&apos;</source>
        <translation>表达式第 {} 列：没有信号“{}”</translation>
    </message>
    <message>
        <source>&apos;{}&apos; defines no signal</source>
        <translation>“{}”没有定义信号</translation>
    </message>
    <message>
        <source>write NAME = EXPRESSION or NAME [UNIT] = EXPRESSION</source>
        <translation>请写 名称 = 表达式 或 名称 [单位] = 表达式</translation>
    </message>
    <message>
        <source>no unit follows from the expression</source>
        <translation>由表达式得不出单位</translation>
    </message>
    <message>
        <source>write the unit of the result, 1 for a number; terms of a sum need equal units</source>
        <translation>请写出结果的单位，纯数写 1；相加的各项单位必须相同</translation>
    </message>
    <message>
        <source>operators are + - * / ^ and comparisons, functions sin, cos, atan2, sqrt, abs, exp, ln, min, max</source>
        <translation>运算符为 + - * / ^ 和比较，函数为 sin、cos、atan2、sqrt、abs、exp、ln、min、max</translation>
    </message>
    <message>
        <source>column {} of the expression: it ends too early</source>
        <translation>表达式第 {} 列：结束过早</translation>
    </message>
    <message>
        <source>column {} of the expression: a ) is missing</source>
        <translation>表达式第 {} 列：缺少 )</translation>
    </message>
    <message>
        <source>every ( has its )</source>
        <translation>每个 ( 都要有对应的 )</translation>
    </message>
    <message>
        <source>column {} of the expression: a : is missing</source>
        <translation>表达式第 {} 列：缺少 :</translation>
    </message>
    <message>
        <source>every ? has its :</source>
        <translation>每个 ? 都要有对应的 :</translation>
    </message>
    <message>
        <source>column {} of the expression: too many arguments of {}</source>
        <translation>表达式第 {} 列：{} 的参数太多</translation>
    </message>
    <message>
        <source>column {} of the expression: too few arguments of {}</source>
        <translation>表达式第 {} 列：{} 的参数太少</translation>
    </message>
    <message>
        <source>column {} of the expression: &apos;{}&apos; is not expected here</source>
        <translation>表达式第 {} 列：此处不应出现“{}”</translation>
    </message>
    <message>
        <source>column {} of the expression: = sets nothing</source>
        <translation>表达式第 {} 列：= 不赋值</translation>
    </message>
    <message>
        <source>== compares</source>
        <translation>== 用于比较</translation>
    </message>
    <message>
        <source>the expression has more than {} letters</source>
        <translation>表达式超过 {} 个字符</translation>
    </message>
    <message>
        <source>divide it: a derived signal of a recording may use those before it</source>
        <translation>请拆分：录制文件的派生信号可以使用其前面的派生信号</translation>
    </message>
    <message>
        <source>the expression has several results</source>
        <translation>表达式有多个结果</translation>
    </message>
    <message>
        <source>write one; the comma separates arguments of functions</source>
        <translation>请只写一个；逗号用于分隔函数参数</translation>
    </message>
    <message>
        <source>&apos;derived&apos; must be a list of tables, [[derived]]</source>
        <translation>&apos;derived&apos; 必须是表的列表，[[derived]]</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a [[derived]] has name, expression, unit</source>
        <translation>未知的键 &apos;{}&apos;；[[derived]] 有 name、expression、unit</translation>
    </message>
    <message>
        <source>a [[derived]] has a name and an expression</source>
        <translation>[[derived]] 须有名称和表达式</translation>
    </message>
    <message>
        <source>the recording ends at {} s, before {} s</source>
        <translation>记录在 {} s 处结束，早于 {} s</translation>
    </message>
    <message>
        <source>begin earlier</source>
        <translation>请从更早处开始</translation>
    </message>
    <message>
        <source>only recordings with their sidecar can have tags and notes</source>
        <translation>只有带附属文件的记录才能有标签和备注</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is damaged</source>
        <translation>“{}”已损坏</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has no rows</source>
        <translation>“{}”没有数据行</translation>
    </message>
    <message>
        <source>&apos;{}&apos; has {} numbers, too many beside the others</source>
        <translation>“{}”有 {} 个数值，与其他记录一起太多</translation>
    </message>
    <message>
        <source>compare fewer recordings, or parts of them (halbench convert --from --to)</source>
        <translation>请比较较少的记录，或只比较其中一部分（halbench convert --from --to）</translation>
    </message>
    <message>
        <source>{}: schema: is not {}</source>
        <translation>{}：schema：不是 {}</translation>
    </message>
    <message>
        <source>make the file with &apos;halbench identify DEVICE --frequency --out&apos;</source>
        <translation>用“halbench identify DEVICE --frequency --out”生成该文件</translation>
    </message>
    <message>
        <source>{}: this response was refused</source>
        <translation>{}：该响应已被拒绝</translation>
    </message>
    <message>
        <source>see its findings, then measure again</source>
        <translation>查看其结论，然后重新测量</translation>
    </message>
    <message>
        <source>{}: sample_period_s: must be more than zero</source>
        <translation>{}：sample_period_s：必须大于零</translation>
    </message>
    <message>
        <source>{}: points[{}]: needs a plant and a frequency above the one before, below half the rate</source>
        <translation>{}：points[{}]：需要被控对象的值，以及高于前一点、低于采样率一半的频率</translation>
    </message>
    <message>
        <source>{}: points: there are none</source>
        <translation>{}：points：没有点</translation>
    </message>
    <message>
        <source>the response was measured every {} ms, this loop runs every {} ms</source>
        <translation>响应的测量周期为 {} ms，而该回路的周期为 {} ms</translation>
    </message>
    <message>
        <source>measure it on this board</source>
        <translation>在该控制板上测量</translation>
    </message>
    <message>
        <source>--out {} would replace the recording itself</source>
        <translation>--out {} 会覆盖记录本身</translation>
    </message>
    <message>
        <source>name another file</source>
        <translation>请指定另一个文件</translation>
    </message>
    <message>
        <source>no base speed from {} to {} rad/s keeps the turn&apos;s harmonics off the lines: a period lasts only {} s</source>
        <translation>{} 至 {} rad/s 之间没有能使转动谐波避开谱线的基准转速：一个周期只有 {} s</translation>
    </message>
    <message>
        <source>use a lower lowest frequency, which makes the period longer</source>
        <translation>请降低最低频率，使周期变长</translation>
    </message>
    <message>
        <source>the history in &apos;{}&apos; cannot be read back: {}</source>
        <translation>无法读回“{}”中的历史数据：{}</translation>
    </message>
    <message>
        <source>damaged (checksum)</source>
        <translation>已损坏（校验和）</translation>
    </message>
    <message>
        <source>what was recorded there is shown as a gap; recordings are not concerned; check the disk</source>
        <translation>该处的数据显示为间断；录制不受影响；请检查磁盘</translation>
    </message>
    <message>
        <source>no room for more history in &apos;{}&apos;: {}</source>
        <translation>“{}”中没有空间存放更多历史数据：{}</translation>
    </message>
    <message>
        <source>the oldest samples are dropped earlier; recordings are not concerned; free disk space</source>
        <translation>最旧的采样会更早被丢弃；录制不受影响；请释放磁盘空间</translation>
    </message>
    <message>
        <source>cannot keep history in &apos;{}&apos;: {}</source>
        <translation>无法在“{}”中保存历史数据：{}</translation>
    </message>
    <message>
        <source>the oldest samples are dropped when memory is full; recordings are not concerned; check the folder and the disk</source>
        <translation>内存用尽时会丢弃最旧的采样；录制不受影响；请检查文件夹和磁盘</translation>
    </message>
    <message>
        <source>more than {} characters in a line</source>
        <translation>一行中超过 {} 个字符</translation>
    </message>
    <message>
        <source>the file may be damaged, or no recording</source>
        <translation>文件可能已损坏，或者不是记录</translation>
    </message>
    <message>
        <source>its numbers need more than {} MB of memory</source>
        <translation>其数值需要超过 {} MB 内存</translation>
    </message>
    <message>
        <source>cut the file into pieces that each begin with its first line</source>
        <translation>把文件切成若干段，每段都以其第一行开头</translation>
    </message>
    <message>
        <source>a stream&apos;s recording waits for a signal&apos;s level</source>
        <translation>数据流的记录等待某个信号的电平</translation>
    </message>
    <message>
        <source>give --trigger SIGNAL&gt;LEVEL or SIGNAL&lt;LEVEL; now and reference belong to --capture</source>
        <translation>请给出 --trigger SIGNAL&gt;LEVEL 或 SIGNAL&lt;LEVEL；now 和 reference 属于 --capture</translation>
    </message>
    <message>
        <source>the time before the trigger must not be negative</source>
        <translation>触发前的时间不能为负</translation>
    </message>
    <message>
        <source>Give e.g. --pre-trigger 2, in seconds.</source>
        <translation>例如 --pre-trigger 2，单位为秒。</translation>
    </message>
    <message>
        <source>there is a [[derived]] named &apos;{}&apos; already</source>
        <translation>已有名为“{}”的 [[derived]]</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a list of texts</source>
        <translation>“{}”必须是文本列表</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; [monitor.trigger] has on, source, mode, slope, level, hysteresis, window_s, pre_trigger_ratio, hold_off_s, board</source>
        <translation>未知的键“{}”；[monitor.trigger] 有 on、source、mode、slope、level、hysteresis、window_s、pre_trigger_ratio、hold_off_s、board</translation>
    </message>
    <message>
        <source>the board&apos;s capture was ended by somebody else</source>
        <translation>控制板的捕获被其他程序结束</translation>
    </message>
    <message>
        <source>another program may be using it; wait again to start it anew</source>
        <translation>可能有另一个程序正在使用它；再次等待即可重新开始</translation>
    </message>
    <message>
        <source>the board gave nothing of its full capture</source>
        <translation>控制板没有给出其已完成的捕获</translation>
    </message>
    <message>
        <source>the board&apos;s capture is in a state that is not known</source>
        <translation>控制板的捕获处于未知状态</translation>
    </message>
    <message>
        <source>update Halbench, or the board&apos;s firmware</source>
        <translation>请更新 Halbench 或控制板的固件</translation>
    </message>
    <message>
        <source>the crossover or margin asked for is not a finite number</source>
        <translation>所要求的穿越频率或裕度不是有限数</translation>
    </message>
    <message>
        <source>no crossover makes a stable position loop of this motor</source>
        <translation>没有任何穿越频率能使该电机构成稳定的位置回路</translation>
    </message>
    <message>
        <source>identify the motor again, or choose a design method</source>
        <translation>重新辨识电机，或选择一种设计方法</translation>
    </message>
    <message>
        <source>the verification move was seen for {} of {} s</source>
        <translation>验证运动只看到了 {} s（共 {} s）</translation>
    </message>
    <message>
        <source>The old values run again. See that the link is not overloaded, and apply again.</source>
        <translation>旧值已恢复。请确认通信链路没有过载，然后重新应用。</translation>
    </message>
    <message>
        <source>the device has several axes and none is named</source>
        <translation>设备有多个轴，但未指定轴</translation>
    </message>
    <message>
        <source>only one axis moves at a time, not all</source>
        <translation>每次只能移动一个轴，不能同时移动全部轴</translation>
    </message>
    <message>
        <source>the device has no axis &apos;{}&apos;</source>
        <translation>设备没有轴 &apos;{}&apos;</translation>
    </message>
    <message>
        <source>the swept rows are not whole sweeps of three signals</source>
        <translation>扫频数据行不是三个信号的完整扫频</translation>
    </message>
    <message>
        <source>{} sweeps say too little of the scatter</source>
        <translation>{} 次扫频不足以说明离散程度</translation>
    </message>
    <message>
        <source>a swept row holds no number</source>
        <translation>某扫频数据行不含数值</translation>
    </message>
    <message>
        <source>a sweep is too short to tell its frequencies apart</source>
        <translation>一次扫频太短，无法区分其频率</translation>
    </message>
    <message>
        <source>{} values are more than are taken out of the plots at once</source>
        <translation>{} 个值超过了一次可从曲线图中取出的数量</translation>
    </message>
    <message>
        <source>zoom in or set the cursors closer, or record it and cut the recording with halbench convert</source>
        <translation>请放大或把光标靠近，或者进行记录并用 halbench convert 截取</translation>
    </message>
    <message>
        <source>the plots have no samples in this stretch of time</source>
        <translation>曲线图在这段时间内没有样本</translation>
    </message>
    <message>
        <source>scroll to where there are some, or move the cursors</source>
        <translation>请滚动到有样本的位置，或移动光标</translation>
    </message>
    <message>
        <source>the generator of this board makes neither multisine nor chirp</source>
        <translation>此板的信号发生器既不能产生多正弦也不能产生扫频信号</translation>
    </message>
    <message>
        <source>sweeps from {} to {} Hz, {} of {}</source>
        <translation>扫频 {} 至 {} Hz，第 {} 次，共 {} 次</translation>
    </message>
    <message>
        <source>waits for the last rows</source>
        <translation>等待最后的数据行</translation>
    </message>
    <message>
        <source>no phase margin: where the loop crosses its phase is not bounded at all</source>
        <translation>无相位裕度：回路穿越处的相位完全无法界定</translation>
    </message>
    <message>
        <source>no gain margin: where the loop crosses its magnitude is not bounded at all</source>
        <translation>无幅值裕度：回路穿越处的幅值完全无法界定</translation>
    </message>
    <message>
        <source>a band of steps of this height and length is not possible</source>
        <translation>不可能有这种高度和长度的阶跃带</translation>
    </message>
    <message>
        <source>the model has no covariance: how uncertain it is is not known</source>
        <translation>模型没有协方差：其不确定程度未知</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a pair of [[cursors]] has name, a_s, b_s, measuring</source>
        <translation>未知的键 &apos;{}&apos;；一对 [[cursors]] 有 name、a_s、b_s、measuring</translation>
    </message>
    <message>
        <source>a pair of [[cursors]] has a name, a_s and b_s</source>
        <translation>一对 [[cursors]] 有 name、a_s 和 b_s</translation>
    </message>
    <message>
        <source>&apos;cursors&apos; must be a list of tables, [[cursors]]</source>
        <translation>&apos;cursors&apos; 必须是表的列表，[[cursors]]</translation>
    </message>
    <message>
        <source>there is a pair of [[cursors]] named &apos;{}&apos; already</source>
        <translation>已有名为 &apos;{}&apos; 的一对 [[cursors]]</translation>
    </message>
    <message>
        <source>only one pair of [[cursors]] is measuring</source>
        <translation>只有一对 [[cursors]] 可以是 measuring</translation>
    </message>
    <message>
        <source>a quoted cell does not end as it should</source>
        <translation>带引号的单元格没有正确结束</translation>
    </message>
    <message>
        <source>{} cells where there are {} before</source>
        <translation>此处有 {} 个单元格，之前有 {} 个</translation>
    </message>
    <message>
        <source>the names of several columns where there is one</source>
        <translation>只有一列，却有多列的名称</translation>
    </message>
    <message>
        <source>there are no rows of numbers</source>
        <translation>没有数字行</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is written with thousands separators</source>
        <translation>“{}” 带有千位分隔符</translation>
    </message>
    <message>
        <source>{} columns are called &apos;{}&apos;</source>
        <translation>有 {} 列名为 “{}”</translation>
    </message>
    <message>
        <source>give its number: {} or {}</source>
        <translation>给出列号：{} 或 {}</translation>
    </message>
    <message>
        <source>the table has no column &apos;{}&apos;</source>
        <translation>表中没有列 “{}”</translation>
    </message>
    <message>
        <source>it has {}; a number from 1 to {} also names one</source>
        <translation>它有 {}；也可用 1 到 {} 的编号指定一列</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no unit that is known</source>
        <translation>“{}” 不是已知的单位</translation>
    </message>
    <message>
        <source>for example s, ms, us, rad, deg, rad/s, rpm, A, mA, T, mT, degC, or - for none</source>
        <translation>例如 s、ms、us、rad、deg、rad/s、rpm、A、mA、T、mT、degC，- 表示无单位</translation>
    </message>
    <message>
        <source>which column is the time is not certain</source>
        <translation>不确定哪一列是时间</translation>
    </message>
    <message>
        <source>column {}</source>
        <translation>第 {} 列</translation>
    </message>
    <message>
        <source>there is none: F rows a second</source>
        <translation>没有：每秒 F 行</translation>
    </message>
    <message>
        <source>the unit of column &apos;{}&apos; is not known</source>
        <translation>列 “{}” 的单位未知</translation>
    </message>
    <message>
        <source>its numbers are in {}</source>
        <translation>其数字的单位是 {}</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is in {}, which is no time</source>
        <translation>列 “{}” 的单位是 {}，不是时间</translation>
    </message>
    <message>
        <source>choose another with --time, or say its unit with --unit</source>
        <translation>用 --time 选择另一列，或用 --unit 给出其单位</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is in {}, but {} is in {}</source>
        <translation>列 “{}” 的单位是 {}，但 {} 的单位是 {}</translation>
    </message>
    <message>
        <source>no unit</source>
        <translation>无单位</translation>
    </message>
    <message>
        <source>map another column with --map, or say its unit with --unit</source>
        <translation>用 --map 对应另一列，或用 --unit 给出其单位</translation>
    </message>
    <message>
        <source>choose the time&apos;s column with --time, or give --rate_Hz</source>
        <translation>用 --time 选择时间列，或给出 --rate_Hz</translation>
    </message>
    <message>
        <source>how columns and numbers are written is not certain</source>
        <translation>不确定列和数字的写法</translation>
    </message>
    <message>
        <source> (thousands separators, which are not read: remove them)</source>
        <translation>（千位分隔符不被读取：请去掉）</translation>
    </message>
    <message>
        <source>whether line {} is a row of numbers or of {} is not certain</source>
        <translation>不确定第 {} 行是数字行还是 {} 行</translation>
    </message>
    <message>
        <source>no header: numbers from the first line on</source>
        <translation>无表头：从第一行起就是数字</translation>
    </message>
    <message>
        <source>one line of names</source>
        <translation>一行名称</translation>
    </message>
    <message>
        <source>a line of names, then one of units</source>
        <translation>一行名称，然后一行单位</translation>
    </message>
    <message>
        <source>write numbers without them</source>
        <translation>请书写不带千位分隔符的数字</translation>
    </message>
    <message>
        <source>a table has rows of equally many numbers, at most two lines of names and units before them, and comments that begin with #; --separator, --decimal and --header say how it is written</source>
        <translation>表由数字个数相同的行组成，其前最多有两行名称和单位，注释以 # 开头；--separator、--decimal 和 --header 说明其写法</translation>
    </message>
    <message>
        <source>UTF-16 text</source>
        <translation>UTF-16 文本</translation>
    </message>
    <message>
        <source>zeros, so this is no text</source>
        <translation>零字节，因此这不是文本</translation>
    </message>
    <message>
        <source>save it as text in UTF-8</source>
        <translation>请另存为 UTF-8 文本</translation>
    </message>
    <message>
        <source>{}:1:1: the lines end with CR alone</source>
        <translation>{}:1:1：行尾只有 CR</translation>
    </message>
    <message>
        <source>save it with line ends LF or CR LF</source>
        <translation>请以行尾 LF 或 CR LF 保存</translation>
    </message>
    <message>
        <source>{}:1:1: there are no rows</source>
        <translation>{}:1:1：没有行</translation>
    </message>
    <message>
        <source>give a file with rows of numbers</source>
        <translation>请给出含有数字行的文件</translation>
    </message>
    <message>
        <source>{}:{}:1: the line has {} characters</source>
        <translation>{}:{}:1：该行有 {} 个字符</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no number that can be held</source>
        <translation>“{}” 不是可以保存的数字</translation>
    </message>
    <message>
        <source>numbers reach from about 1e-308 to 1e308</source>
        <translation>数字的范围约为 1e-308 到 1e308</translation>
    </message>
    <message>
        <source>numbers of this table are written like -1{}5e-3; --decimal says otherwise</source>
        <translation>此表的数字写作 -1{}5e-3；可用 --decimal 另行指定</translation>
    </message>
    <message>
        <source>the line has {} characters</source>
        <translation>该行有 {} 个字符</translation>
    </message>
    <message>
        <source>a quote inside a quoted cell is written twice</source>
        <translation>带引号的单元格内的引号要写两次</translation>
    </message>
    <message>
        <source>{} cells where the table has {} columns</source>
        <translation>此处有 {} 个单元格，而表有 {} 列</translation>
    </message>
    <message>
        <source>the time is missing</source>
        <translation>缺少时间</translation>
    </message>
    <message>
        <source>remove the row, or give --rate_Hz instead</source>
        <translation>删除该行，或改为给出 --rate_Hz</translation>
    </message>
    <message>
        <source>the time does not increase: {} s after {} s</source>
        <translation>时间没有递增：{} s 在 {} s 之后</translation>
    </message>
    <message>
        <source>sort the rows by time, choose another column with --time, or give --rate_Hz</source>
        <translation>按时间排序各行，用 --time 选择另一列，或给出 --rate_Hz</translation>
    </message>
    <message>
        <source>--rate_Hz: not between 1e-6 and 1e9</source>
        <translation>--rate_Hz：不在 1e-6 与 1e9 之间</translation>
    </message>
    <message>
        <source>give how many rows were sampled in a second</source>
        <translation>给出每秒采样的行数</translation>
    </message>
    <message>
        <source>--time and --rate_Hz both say where the time comes from</source>
        <translation>--time 和 --rate_Hz 都指定了时间来源</translation>
    </message>
    <message>
        <source>give one of them</source>
        <translation>只给出其中一个</translation>
    </message>
    <message>
        <source>{}: {} columns</source>
        <translation>{}：{} 列</translation>
    </message>
    <message>
        <source>unit not known</source>
        <translation>单位未知</translation>
    </message>
    <message>
        <source>the unit &apos;{}&apos; of column &apos;{}&apos; is not known: its numbers stay as they are, without a unit</source>
        <translation>单位“{}”（列“{}”）未知：其数字保持不变，无单位</translation>
    </message>
    <message>
        <source>say its unit with --unit</source>
        <translation>用 --unit 给出其单位</translation>
    </message>
    <message>
        <source>the steps of the time lie between {} s and {} s</source>
        <translation>时间步长在 {} s 与 {} s 之间</translation>
    </message>
    <message>
        <source>the times are kept as they are; what needs an even rate may refuse them</source>
        <translation>时间保持不变；需要均匀采样的功能可能会拒绝</translation>
    </message>
    <message>
        <source>{} rows are missing</source>
        <translation>缺少 {} 行</translation>
    </message>
    <message>
        <source>the sidecar says where</source>
        <translation>附属文件说明位置</translation>
    </message>
    <message>
        <source>a [[plot]] with its own time axis has own_span_s, which is more than 0</source>
        <translation>有自己时间轴的 [[plot]] 有 own_span_s，且大于 0</translation>
    </message>
    <message>
        <source>{}: there is such a file already</source>
        <translation>{}：已有此文件</translation>
    </message>
    <message>
        <source>give the recording another name</source>
        <translation>请为记录换一个名称</translation>
    </message>
    <message>
        <source>the import was cancelled</source>
        <translation>导入已取消</translation>
    </message>
    <message>
        <source>{}: cannot be read</source>
        <translation>{}：无法读取</translation>
    </message>
    <message>
        <source>look whether it is still there</source>
        <translation>请查看它是否还在</translation>
    </message>
    <message>
        <source>nothing is shown that could be saved</source>
        <translation>没有显示可以保存的内容</translation>
    </message>
    <message>
        <source>wait until there is a picture</source>
        <translation>请等到有图片显示</translation>
    </message>
    <message>
        <source>the measured motion left the predicted band at {} s, by {} degrees</source>
        <translation>测得的运动在 {} s 离开了预测范围，超出 {} 度</translation>
    </message>
    <message>
        <source>step {} of {} is not safe: {} % of the motors that the data allow make its loop unstable, its margins are {} deg and {}</source>
        <translation>第 {} 步（共 {} 步）不安全：数据允许的电机中有 {} % 使其回路不稳定，其裕度为 {} 度和 {}</translation>
    </message>
    <message>
        <source>nothing was written; choose gains with larger margins, or identify more precisely</source>
        <translation>未写入任何内容；请选择裕度更大的增益，或更精确地辨识</translation>
    </message>
    <message>
        <source>steps of a factor {} do not get anywhere</source>
        <translation>每步 {} 倍无法到达任何地方</translation>
    </message>
    <message>
        <source>allow at least 1.05</source>
        <translation>请至少允许 1.05</translation>
    </message>
    <message>
        <source>the way to these gains takes more than 40 steps</source>
        <translation>到达这些增益需要超过 40 步</translation>
    </message>
    <message>
        <source>allow larger steps, or apply gains that are nearer first</source>
        <translation>请允许更大的步长，或先应用更接近的增益</translation>
    </message>
    <message>
        <source>step {} of {}: {}</source>
        <translation>第 {} 步（共 {} 步）：{}</translation>
    </message>
    <message>
        <source>more than a twentieth of the measured motion was outside the predicted band</source>
        <translation>测得的运动有超过二十分之一在预测范围之外</translation>
    </message>
    <message>
        <source>the new gains were not kept</source>
        <translation>新增益未保留</translation>
    </message>
    <message>
        <source>the uncertainty of the model allows no motor at all</source>
        <translation>模型的不确定度不允许任何电机</translation>
    </message>
    <message>
        <source>identify the motor again</source>
        <translation>请重新辨识电机</translation>
    </message>
    <message>
        <source>a recorded move of {} s cannot be replayed</source>
        <translation>无法重放 {} s 的记录运动</translation>
    </message>
    <message>
        <source>record {} to {} s of a move</source>
        <translation>请记录 {} 至 {} s 的运动</translation>
    </message>
    <message>
        <source>rows are missing at {} s: what happened there is not known</source>
        <translation>在 {} s 处缺行：那里发生了什么不得而知</translation>
    </message>
    <message>
        <source>record the move again, at 100 Hz or more</source>
        <translation>请以 100 Hz 或更高速率重新记录该运动</translation>
    </message>
    <message>
        <source>the rotor moves already when the recording begins</source>
        <translation>记录开始时转子已在运动</translation>
    </message>
    <message>
        <source>replay a recording that begins with its move, as `halbench move --out` writes it</source>
        <translation>请重放以其运动开始的记录，如 `halbench move --out` 所写</translation>
    </message>
    <message>
        <source>the recording has no {}</source>
        <translation>记录中没有 {}</translation>
    </message>
    <message>
        <source>a move is replayed from position, reference and current_command</source>
        <translation>重放运动需要 position、reference 和 current_command</translation>
    </message>
    <message>
        <source>record the move again</source>
        <translation>请重新记录该运动</translation>
    </message>
    <message>
        <source>the identified loop with the gains that ran does not explain the recorded move: {} % of it lie outside the predicted band</source>
        <translation>辨识的回路在当时运行的增益下不能解释记录的运动：其中 {} % 在预测范围之外</translation>
    </message>
    <message>
        <source>the band is widened until it holds the record; identify the motor anew for a better one</source>
        <translation>范围已加宽到包含该记录；要得到更好的范围，请重新辨识电机</translation>
    </message>
    <message>
        <source>nothing follows from this record for other gains: identify the motor anew, or choose a record of this motor with these gains</source>
        <translation>从该记录得不出其他增益的任何结论：请重新辨识电机，或选择此电机在这些增益下的记录</translation>
    </message>
    <message>
        <source>with these gains the loop is unstable: no motion is predicted</source>
        <translation>在这些增益下回路不稳定：不预测运动</translation>
    </message>
    <message>
        <source>choose gains that are stable</source>
        <translation>请选择稳定的增益</translation>
    </message>
    <message>
        <source>these gains magnify what the model does not know {} times more than those that ran: the band is that much wider</source>
        <translation>这些增益把模型所不知道的部分放大到当时运行的增益的 {} 倍：范围也相应加宽</translation>
    </message>
    <message>
        <source>apply them in small steps, or choose gains with a larger modulus margin</source>
        <translation>请以小步应用，或选择模裕度更大的增益</translation>
    </message>
    <message>
        <source>name mask, character {}: {}</source>
        <translation>名称模板，第 {} 个字符：{}</translation>
    </message>
    <message>
        <source>known are {device}, {name}, {date}, {time} and {number}</source>
        <translation>可用的有 {device}、{name}、{date}、{time} 和 {number}</translation>
    </message>
    <message>
        <source>a &apos;{&apos; without its &apos;}&apos;</source>
        <translation>“{”缺少对应的“}”</translation>
    </message>
    <message>
        <source>there is no placeholder &apos;{}&apos;</source>
        <translation>没有占位符“{}”</translation>
    </message>
    <message>
        <source>a &apos;}&apos; without its &apos;{&apos;</source>
        <translation>“}”缺少对应的“{”</translation>
    </message>
    <message>
        <source>a name has no folder in it</source>
        <translation>名称中不能有文件夹</translation>
    </message>
    <message>
        <source>the folder has a field of its own</source>
        <translation>文件夹有自己的输入框</translation>
    </message>
    <message>
        <source>file systems refuse &apos;{}&apos;</source>
        <translation>文件系统不接受“{}”</translation>
    </message>
    <message>
        <source>use letters, digits, &apos;-&apos;, &apos;_&apos; and &apos;.&apos;</source>
        <translation>请使用字母、数字、“-”、“_”和“.”</translation>
    </message>
    <message>
        <source>a second {number}</source>
        <translation>第二个 {number}</translation>
    </message>
    <message>
        <source>one number is enough</source>
        <translation>一个编号就够了</translation>
    </message>
    <message>
        <source>the name mask is empty</source>
        <translation>名称模板为空</translation>
    </message>
    <message>
        <source>write e.g. {}</source>
        <translation>例如写 {}</translation>
    </message>
    <message>
        <source>a name begins with neither a space nor a point</source>
        <translation>名称不能以空格或点开头</translation>
    </message>
    <message>
        <source>begin with a letter</source>
        <translation>请以字母开头</translation>
    </message>
    <message>
        <source>the ending is added to the name</source>
        <translation>扩展名会自动加在名称后面</translation>
    </message>
    <message>
        <source>leave .csv out</source>
        <translation>请去掉 .csv</translation>
    </message>
    <message>
        <source>the recording&apos;s name would have {} octets</source>
        <translation>记录的名称将有 {} 字节</translation>
    </message>
    <message>
        <source>shorten the name or its mask to {} octets</source>
        <translation>请把名称或其模板缩短到 {} 字节</translation>
    </message>
    <message>
        <source>say e.g. --retain 30d, --retain 20GB or --retain 30d,20GB</source>
        <translation>例如写 --retain 30d、--retain 20GB 或 --retain 30d,20GB</translation>
    </message>
    <message>
        <source>cannot remove &apos;{}&apos;: {}</source>
        <translation>无法移除“{}”：{}</translation>
    </message>
    <message>
        <source>--retain does not understand &apos;{}&apos;</source>
        <translation>--retain 不理解“{}”</translation>
    </message>
    <message>
        <source>--retain needs a limit</source>
        <translation>--retain 需要一个限制</translation>
    </message>
    <message>
        <source>it has tags</source>
        <translation>它有标签</translation>
    </message>
    <message>
        <source>it has notes</source>
        <translation>它有备注</translation>
    </message>
    <message>
        <source>a file beside it bears its name</source>
        <translation>旁边有文件带有它的名称</translation>
    </message>
    <message>
        <source>it is open</source>
        <translation>它是打开的</translation>
    </message>
    <message>
        <source>it is of the last 24 hours</source>
        <translation>它属于最近 24 小时</translation>
    </message>
    <message>
        <source>it is write-protected</source>
        <translation>它被写保护</translation>
    </message>
    <message>
        <source>it is a link</source>
        <translation>它是一个链接</translation>
    </message>
    <message>
        <source>its rows were changed</source>
        <translation>它的数据行已被更改</translation>
    </message>
    <message>
        <source>&apos;{}&apos; stays: {}</source>
        <translation>“{}”保留：{}</translation>
    </message>
    <message>
        <source>it is looked at again the next time</source>
        <translation>下次会再次检查</translation>
    </message>
    <message>
        <source>&apos;{}&apos; of a recording is from 0 to {} s</source>
        <translation>记录的“{}”为 0 到 {} s</translation>
    </message>
    <message>
        <source>&apos;recording&apos; must be a table</source>
        <translation>“recording”必须是一个表</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; [recording] has before_s, at_trigger, after_s</source>
        <translation>未知键“{}”；[recording] 有 before_s、at_trigger、after_s</translation>
    </message>
    <message>
        <source>wait longer (--wait; wait_s of a step), or choose another trigger</source>
        <translation>等待更久（--wait；步骤的 wait_s），或选择其他触发</translation>
    </message>
    <message>
        <source>holds its position</source>
        <translation>保持位置</translation>
    </message>
    <message>
        <source>makes the move</source>
        <translation>正在运动</translation>
    </message>
    <message>
        <source>the trash does not take &apos;{}&apos;</source>
        <translation>回收站不接收“{}”</translation>
    </message>
    <message>
        <source>empty the trash; where a disk has none, `halbench recordings --retain ... --delete` deletes for good</source>
        <translation>请清空回收站；磁盘没有回收站时，`halbench recordings --retain ... --delete` 会永久删除</translation>
    </message>
    <message>
        <source>least integral of the absolute error after a load, with Ms and current within bounds</source>
        <translation>负载之后绝对误差的积分最小，Ms 与电流不超过界限</translation>
    </message>
    <message>
        <source>the target {} = {} is not between {} and {}</source>
        <translation>目标 {} = {} 不在 {} 与 {} 之间</translation>
    </message>
    <message>
        <source>1.4 is calm, 1.7 usual, 2 lively</source>
        <translation>1.4 为平稳，1.7 为常用，2 为活跃</translation>
    </message>
    <message>
        <source>give the current that the motor can take, in A</source>
        <translation>给出电机可承受的电流，单位 A</translation>
    </message>
    <message>
        <source>give the largest step that shall not saturate, in degrees</source>
        <translation>给出不应达到电流限值的最大阶跃，单位为度</translation>
    </message>
    <message>
        <source>the target step-deg needs the target current-limit-a</source>
        <translation>目标 step-deg 需要目标 current-limit-a</translation>
    </message>
    <message>
        <source>say how much current that step may ask for</source>
        <translation>说明该阶跃可要求多大电流</translation>
    </message>
    <message>
        <source>no gains with a peak of sensitivity up to {} were found for this motor: the calmest loop has {}</source>
        <translation>没有为此电机找到灵敏度峰值不超过 {} 的增益：最平稳的回路为 {}</translation>
    </message>
    <message>
        <source>no gains that ask for {} A at most in a step of {} deg were found for this motor: {} A are needed</source>
        <translation>没有为此电机找到在 {1} 度阶跃中至多要求 {0} A 的增益：需要 {2} A</translation>
    </message>
    <message>
        <source>allow more current, or a smaller step</source>
        <translation>允许更大的电流，或更小的阶跃</translation>
    </message>
    <message>
        <source>the target current-limit-a = {} is above the board&apos;s own limit of {} A</source>
        <translation>目标 current-limit-a = {} 高于控制板自身的限值 {} A</translation>
    </message>
    <message>
        <source>choose up to that, or leave it out</source>
        <translation>不超过该值，或不填</translation>
    </message>
    <message>
        <source>any motion</source>
        <translation>任何运动</translation>
    </message>
    <message>
        <source>a swing beyond +-{} deg</source>
        <translation>超过 +-{} deg 的摆动</translation>
    </message>
    <message>
        <source>{} grows into a lasting one of about +-{} deg at {} Hz</source>
        <translation>{} 会长成约 +-{} deg、{} Hz 的持续振荡</translation>
    </message>
    <message>
        <source>keep to small steps, or choose a smaller K_P</source>
        <translation>只用小阶跃，或选择较小的 K_P</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot name a signal: it is the time</source>
        <translation>“{}”不能作为信号名称：它是时间</translation>
    </message>
    <message>
        <source>&apos;{}&apos; cannot name a signal</source>
        <translation>“{}”不能作为信号名称</translation>
    </message>
    <message>
        <source>a name has letters, digits, &apos;.&apos; and &apos;_&apos; and begins with a letter</source>
        <translation>名称由字母、数字、“.”和“_”组成，并以字母开头</translation>
    </message>
    <message>
        <source>the name &apos;{}&apos; is given to two columns</source>
        <translation>名称“{}”被赋予两列</translation>
    </message>
    <message>
        <source>give every column a name of its own</source>
        <translation>请给每列一个各自的名称</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is given two names</source>
        <translation>列“{}”被赋予两个名称</translation>
    </message>
    <message>
        <source>give every column one name</source>
        <translation>请给每列一个名称</translation>
    </message>
    <message>
        <source>column &apos;{}&apos; is the time and cannot be called &apos;{}&apos;</source>
        <translation>列“{}”是时间，不能称为“{}”</translation>
    </message>
    <message>
        <source>the ultimate gain and the ultimate period belong together</source>
        <translation>临界增益和临界周期必须一起给出</translation>
    </message>
    <message>
        <source>give both, as the relay experiment found them, or leave both to the model</source>
        <translation>请按继电实验的结果给出两者，或者都由模型决定</translation>
    </message>
    <message>
        <source>the rows of the cycle are not three signals of one length</source>
        <translation>振荡的各行不是三个等长的信号</translation>
    </message>
    <message>
        <source>a row of the cycle holds no number</source>
        <translation>振荡记录中有一行不是数字</translation>
    </message>
    <message>
        <source>no rotor has the response that the cycle shows</source>
        <translation>没有任何转子具有该振荡所显示的响应</translation>
    </message>
    <message>
        <source>look at the record: an angle error or a resonance may be in it</source>
        <translation>请查看记录：其中可能有角度误差或谐振</translation>
    </message>
    <message>
        <source>the loop swings {} times in the record: that is no limit cycle</source>
        <translation>回路在记录中振荡了 {} 次：这不是极限环</translation>
    </message>
    <message>
        <source>use a larger gain of the relay, or the model of this motor</source>
        <translation>请使用更大的继电增益，或此电机的模型</translation>
    </message>
    <message>
        <source>this motor does not damp: proportional control swings at any gain</source>
        <translation>此电机没有阻尼：比例控制在任何增益下都会振荡</translation>
    </message>
    <message>
        <source>there is no ultimate gain; use a method with derivative action</source>
        <translation>不存在临界增益；请使用带微分作用的方法</translation>
    </message>
    <message>
        <source>at the cycle&apos;s frequency the phase is {} deg, too far from -180 deg</source>
        <translation>在振荡频率处相位为 {} 度，离 -180 度太远</translation>
    </message>
    <message>
        <source>at most {} deg are allowed: look for a delay that the board does not tell, or a resonance</source>
        <translation>最多允许 {} 度：请检查控制板未说明的时延，或谐振</translation>
    </message>
    <message>
        <source>rows are missing: the cycles do not fit together</source>
        <translation>缺少数据行：各个周期无法衔接</translation>
    </message>
    <message>
        <source>the cycle&apos;s frequency wanders by {} %: the angle&apos;s errors drive it with the turn, {} % are allowed</source>
        <translation>振荡频率漂移了 {} %：角度误差使其随转动变化，允许 {} %</translation>
    </message>
    <message>
        <source>calibrate the sensors and apply it, then measure again</source>
        <translation>请标定传感器并应用，然后重新测量</translation>
    </message>
    <message>
        <source>the cycle&apos;s amplitude changes by {} % from the first third to the last</source>
        <translation>振荡幅值从前三分之一到后三分之一变化了 {} %</translation>
    </message>
    <message>
        <source>measure more cycles, or give the relay a larger gain; calibrate the sensors first</source>
        <translation>请测量更多周期，或增大继电增益；请先标定传感器</translation>
    </message>
    <message>
        <source>the ultimate gain lies between {} and {} A/rad: that is no answer</source>
        <translation>临界增益介于 {} 与 {} A/rad 之间：这不算结果</translation>
    </message>
    <message>
        <source>measure more cycles; calibrate the sensors first</source>
        <translation>请测量更多周期；请先标定传感器</translation>
    </message>
    <message>
        <source>the ultimate gain is known to {} % only</source>
        <translation>临界增益只精确到 {} %</translation>
    </message>
    <message>
        <source>the model foresees an ultimate gain of {} to {} A/rad, measured were {} to {}</source>
        <translation>模型预计临界增益为 {} 至 {} A/rad，实测为 {} 至 {}</translation>
    </message>
    <message>
        <source>identify the motor again: it has changed, or one of the two is wrong</source>
        <translation>请重新辨识电机：电机已改变，或两者之一有误</translation>
    </message>
    <message>
        <source>whether it agrees with the model is not known: the model has no covariance</source>
        <translation>无法判断是否与模型一致：模型没有协方差</translation>
    </message>
    <message>
        <source>it was compared with no model of this motor</source>
        <translation>未与此电机的模型进行比较</translation>
    </message>
    <message>
        <source>identify the motor and give its model</source>
        <translation>请辨识电机并给出其模型</translation>
    </message>
    <message>
        <source>speed limit in rad/s</source>
        <translation>速度限值（rad/s）</translation>
    </message>
    <message>
        <source>number of cycles</source>
        <translation>周期数</translation>
    </message>
    <message>
        <source>height of the relay in A</source>
        <translation>继电幅值（A）</translation>
    </message>
    <message>
        <source>gain of the relay in A/rad</source>
        <translation>继电增益（A/rad）</translation>
    </message>
    <message>
        <source>on a base of {} rad/s no relay swings the loop by {} rad without bringing the rotor near standstill or above {} rad/s</source>
        <translation>在 {} rad/s 的基础速度下，没有任何继电幅值能使回路摆动 {} rad 而不使转子接近静止或超过 {} rad/s</translation>
    </message>
    <message>
        <source>no base speed from {} to {} rad/s lets a relay swing the loop by {} rad without bringing the rotor near standstill</source>
        <translation>从 {} 到 {} rad/s 没有任何基础速度能让继电使回路摆动 {} rad 而不使转子接近静止</translation>
    </message>
    <message>
        <source>leave base speed and height of the relay to the program, allow a higher speed or more current, or use the model of this motor</source>
        <translation>请让程序选择基础速度和继电幅值，允许更高的速度或更大的电流，或使用此电机的模型</translation>
    </message>
    <message>
        <source>calibrate the sensors and apply it, use the model of this motor, or a lower relay</source>
        <translation>请标定传感器并应用，使用此电机的模型，或更低的继电幅值</translation>
    </message>
    <message>
        <source>the rotor reached {} rad/s, foreseen were {}</source>
        <translation>转子达到 {} rad/s，预计为 {}</translation>
    </message>
    <message>
        <source>identify the motor and give its model: the plan was made for another one</source>
        <translation>请辨识电机并给出其模型：计划是为另一台电机制定的</translation>
    </message>
    <message>
        <source>swings around a steady motion</source>
        <translation>围绕匀速运动摆动</translation>
    </message>
    <message>
        <source>the device has no parameter for {}</source>
        <translation>设备没有用于 {} 的参数</translation>
    </message>
    <message>
        <source>the relay experiment needs a position loop with a gain and a current limit</source>
        <translation>继电实验需要带增益和电流限值的位置回路</translation>
    </message>
    <message>
        <source>the clock is in doubt</source>
        <translation>时钟可疑</translation>
    </message>
    <message>
        <source>{}: which gains ran is not recorded beside it</source>
        <translation>{}：旁边没有记录当时运行的增益</translation>
    </message>
    <message>
        <source>{}: {} was changed at {} s of the recording</source>
        <translation>{}：{} 在记录的 {} s 处被更改</translation>
    </message>
    <message>
        <source>record a move under one set of gains</source>
        <translation>请用同一组增益记录一次运动</translation>
    </message>
    <message>
        <source>{}: the gains that ran are of another sample period</source>
        <translation>{}：当时运行的增益属于另一采样周期</translation>
    </message>
    <message>
        <source>compare gains of one board</source>
        <translation>请比较同一控制板的增益</translation>
    </message>
    <message>
        <source>the gains were found for the {} &apos;{}&apos;, this device is the {} &apos;{}&apos;</source>
        <translation>这些增益是为 {} “{}”求得的，而此设备是 {} “{}”</translation>
    </message>
    <message>
        <source>the gains were found for &apos;{}&apos; with other overrides than this device has</source>
        <translation>这些增益是为“{}”求得的，其覆盖参数与此设备不同</translation>
    </message>
    <message>
        <source>the gains are for {} s with {} samples of delay, this device has {} s and {}: they are judged as they would run on it</source>
        <translation>这些增益适用于 {} s 和 {} 个采样的时延，而此设备为 {} s 和 {}：按其在此设备上运行的情形评判</translation>
    </message>
    <message>
        <source>design them for the timing of this device</source>
        <translation>请按此设备的时序进行设计</translation>
    </message>
    <message>
        <source>{}; nothing was written</source>
        <translation>{}；未写入任何内容</translation>
    </message>
    <message>
        <source>these gains are refused; nothing was written</source>
        <translation>这些增益被拒绝；未写入任何内容</translation>
    </message>
    <message>
        <source>see their findings</source>
        <translation>请查看其结论</translation>
    </message>
    <message>
        <source>{} signals cannot come at {} Hz: board and link carry at most {} Hz</source>
        <translation>{} 个信号无法以 {} Hz 到来：控制板和链路至多承载 {} Hz</translation>
    </message>
    <message>
        <source>take a lower rate or fewer signals; a port that is USB all the way to the board is faster than its baud rate: say so in its address with ?baud=12000000</source>
        <translation>请采用较低的速率或较少的信号；一直到控制板都是 USB 的端口比其波特率更快：请在其地址中用 ?baud=12000000 说明</translation>
    </message>
    <message>
        <source>take a lower rate or fewer signals</source>
        <translation>请采用较低的速率或较少的信号</translation>
    </message>
    <message>
        <source>[monitor] has follow and cursors (true or false), span_s, rate_hz and trigger</source>
        <translation>[monitor] 有 follow 和 cursors（true 或 false）、span_s、rate_hz 和 trigger</translation>
    </message>
    <message>
        <source>&apos;rate_hz&apos; must not be negative</source>
        <translation>“rate_hz”不能为负</translation>
    </message>
    <message>
        <source>must be &quot;parallel&quot;, &quot;standard&quot; or &quot;series&quot;</source>
        <translation>必须是“parallel”、“standard”或“series”</translation>
    </message>
    <message>
        <source>{}: gains.filter_s: {}</source>
        <translation>{}: gains.filter_s: {}</translation>
    </message>
    <message>
        <source>{}: gains: {}</source>
        <translation>{}: gains: {}</translation>
    </message>
    <message>
        <source>is nothing that the board&apos;s law has</source>
        <translation>不属于控制板控制律的内容</translation>
    </message>
    <message>
        <source>a band under a load of {} A is not possible</source>
        <translation>负载为 {} A 的范围带是不可能的</translation>
    </message>
    <message>
        <source>another program changes &apos;{}&apos;</source>
        <translation>另一个程序正在更改“{}”</translation>
    </message>
    <message>
        <source>only recordings with their sidecar keep markers that are changed later</source>
        <translation>只有带附属文件的记录才能保存之后更改的标记</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; known are schema, device, notes, perspective, layout, monitor, monitor2, monitor3, recording, plot, cursors, derived, given, model, design, calibration</source>
        <translation>未知的键“{}”；已知的有 schema、device、notes、perspective、layout、monitor、monitor2、monitor3、recording、plot、cursors、derived、given、model、design、calibration</translation>
    </message>
    <message>
        <source>a set-point weight is not a finite number</source>
        <translation>设定值权重不是有限数</translation>
    </message>
    <message>
        <source>the set-point weight {} = {} is not between 0 and 1</source>
        <translation>设定值权重 {} = {} 不在 0 到 1 之间</translation>
    </message>
    <message>
        <source>without integral action the set-point weight b = {} leaves the motor at {} times its reference</source>
        <translation>没有积分作用时，设定值权重 b = {} 会使电机停在设定值的 {} 倍处</translation>
    </message>
    <message>
        <source>add integral action, or leave b at 1</source>
        <translation>加入积分作用，或将 b 保持为 1</translation>
    </message>
    <message>
        <source>{} filters are more than {}</source>
        <translation>{} 个滤波器多于 {} 个</translation>
    </message>
    <message>
        <source>&apos;units&apos; must be a table of signals with their units, units.position = &quot;mrad&quot;</source>
        <translation>“units”必须是由信号及其单位组成的表，如 units.position = &quot;mrad&quot;</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is no unit that a signal is shown in; there are {}</source>
        <translation>“{}”不是信号可以用来显示的单位；可用的有 {}</translation>
    </message>
    <message>
        <source>&apos;units&apos; names &apos;{}&apos;, which this [[plot]] does not show</source>
        <translation>“units”中的“{}”不是这个 [[plot]] 所显示的信号</translation>
    </message>
    <message>
        <source>leave it out to use these gains; weights and filters are judged by &apos;halbench analyse&apos; and &apos;halbench tune --gains&apos;</source>
        <translation>要使用这些增益，请将其去掉；权重和滤波器由 &apos;halbench analyse&apos; 和 &apos;halbench tune --gains&apos; 评判</translation>
    </message>
    <message>
        <source>&apos;{}&apos; must be a whole number from 1 to {}</source>
        <translation>“{}”必须是 1 到 {} 之间的整数</translation>
    </message>
    <message>
        <source>unknown key &apos;{}&apos;; a [[plot]] has signals, min, max, unit, right, right_min, right_max, right_unit, own_span_s, own_follow, column, height_percent, width_percent, units</source>
        <translation>未知的键“{}”；[[plot]] 有 signals、min、max、unit、right、right_min、right_max、right_unit、own_span_s、own_follow、column、height_percent、width_percent、units</translation>
    </message>
    <message>
        <source>&apos;{}&apos; was changed since it was recorded: {} of {} rows</source>
        <translation>“{}”自录制以来已被更改：{} / {} 行</translation>
    </message>
    <message>
        <source>one signal cannot come at {} Hz: board and link carry at most {} Hz</source>
        <translation>一个信号无法以 {} Hz 到来：控制板和链路至多承载 {} Hz</translation>
    </message>
    <message>
        <source>&apos;{}&apos; is a device or pipe</source>
        <translation>“{}”是设备或管道</translation>
    </message>
    <message>
        <source>no row of &apos;{}&apos; is undamaged</source>
        <translation>“{}”中没有一行未损坏</translation>
    </message>
    <message>
        <source>it stays as it is: what is in it can be read as text</source>
        <translation>文件保持原样：其中的内容可以作为文本阅读</translation>
    </message>
    <message>
        <source>it stays as it is; to read what its checksums do not confirm, move &apos;{}&apos; away</source>
        <translation>文件保持原样；若要读取校验和未确认的内容，请移走“{}”</translation>
    </message>
    <message>
        <source>a step of {} s is not simulated with a sampling period of {} s</source>
        <translation>{} s 的阶跃不会以 {} s 的采样周期进行仿真</translation>
    </message>
    <message>
        <source>give a period of {} s or more</source>
        <translation>请给出 {} s 或更长的周期</translation>
    </message>
    <message>
        <source>a recorded move has rows of 1 ms and cannot be replayed through a loop of {} ms</source>
        <translation>记录的运动每行为 1 ms，无法通过 {} ms 的回路重放</translation>
    </message>
    <message>
        <source>what if needs a sampling period of whole milliseconds</source>
        <translation>假设分析需要整毫秒的采样周期</translation>
    </message>
    <message>
        <source>the step has no figures: its slowest part decays by {} in a sample, far longer than what is simulated</source>
        <translation>该阶跃没有指标：其最慢部分每个采样衰减 {}，远长于所仿真的时间</translation>
    </message>
    <message>
        <source>choose gains with faster poles, or a longer sampling period</source>
        <translation>请选择极点更快的增益，或更长的采样周期</translation>
    </message>
    <message>
        <source>with friction and the current limit a step of {} deg is not there after {} s: how far it overshoots is not known</source>
        <translation>在摩擦和电流限制下，{} deg 的阶跃在 {} s 后仍未到达：超调多少未知</translation>
    </message>
    <message>
        <source>choose a faster loop, or one with more integral action</source>
        <translation>请选择更快的回路，或积分作用更强的回路</translation>
    </message>
    <message>
        <source>must be a positive time in seconds</source>
        <translation>必须是以秒为单位的正的时间</translation>
    </message>
    <message>
        <source>the motor was measured at {} s with {} samples of delay, this device has {} s and {}</source>
        <translation>该电机是在 {} s、{} 个采样的时延下测量的，而此设备为 {} s 和 {}</translation>
    </message>
    <message>
        <source>identify the motor with the delay that this device has now</source>
        <translation>请在此设备现有的时延下辨识电机</translation>
    </message>
    <message>
        <source>wrong sign of current or angle: the current accelerates the rotor backwards, its torque constant would be negative</source>
        <translation>电流或角度的符号错误：电流使转子反向加速，其转矩常数将为负</translation>
    </message>
    <message>
        <source>turn the sign of one of the two on the board and measure again</source>
        <translation>在电路板上将二者之一的符号反转，然后重新测量</translation>
    </message>
    <message>
        <source>the interval of phi/J reaches zero</source>
        <translation>phi/J 的区间触及零</translation>
    </message>
    <message>
        <source>a damping below zero came out, which no motor has</source>
        <translation>得出的阻尼小于零，任何电机都不会如此</translation>
    </message>
    <message>
        <source>check the delay of the loop, and that nothing else drives the rotor</source>
        <translation>检查回路的延迟，并确认没有别的东西驱动转子</translation>
    </message>
    <message>
        <source>turns against its current</source>
        <translation>逆着电流转动</translation>
    </message>
    <message>
        <source>wrong sign of current or angle: {}</source>
        <translation>电流或角度的符号错误：{}</translation>
    </message>
    <message>
        <source>turn the sign of one of the two columns (or of the command on the board) and identify again</source>
        <translation>将两列之一（或电路板上指令）的符号反转，然后重新辨识</translation>
    </message>
    <message>
        <source>a friction below zero came out, which no motor has</source>
        <translation>得出的摩擦小于零，任何电机都不会如此</translation>
    </message>
    <message>
        <source>friction cannot be told from zero: it is at most {} % of the torque</source>
        <translation>摩擦与零无法区分：至多为转矩的 {} %</translation>
    </message>
    <message>
        <source>friction is undecided: between zero and {} % of the largest torque</source>
        <translation>摩擦未定：介于零与最大转矩的 {} % 之间</translation>
    </message>
    <message>
        <source>damping cannot be told from zero: it is at most {} % of the torque</source>
        <translation>阻尼与零无法区分：至多为转矩的 {} %</translation>
    </message>
    <message>
        <source>damping is undecided: between zero and {} % of the largest torque</source>
        <translation>阻尼未定：介于零与最大转矩的 {} % 之间</translation>
    </message>
    <message>
        <source>current and angle do not belong together: check their units, that no column is shifted in time, and that nothing else drives the rotor</source>
        <translation>电流与角度不相符：检查它们的单位，确认没有列在时间上错位，也没有别的东西驱动转子</translation>
    </message>
    <message>
        <source>record more run-ups and coast-downs, over a wider range of speed</source>
        <translation>在更宽的转速范围内记录更多的加速和滑行</translation>
    </message>
    <message>
        <source>the value is zero and its interval begins there</source>
        <translation>其值为零，区间由此开始</translation>
    </message>
    <message>
        <source>the current accelerates the rotor backwards, its torque constant would be negative</source>
        <translation>电流使转子反向加速，其转矩常数将为负</translation>
    </message>
    <message>
        <source>an inertia below zero came out, which no rotor has</source>
        <translation>得出的转动惯量小于零，任何转子都不会如此</translation>
    </message>
    <message>
        <source>check the given constants, and the units of current and angle</source>
        <translation>检查给定的常数以及电流和角度的单位</translation>
    </message>
    <message>
        <source>the interval of the torque constant or of the inertia reaches zero</source>
        <translation>转矩常数或转动惯量的区间触及零</translation>
    </message>
    <message>
        <source>use larger and more different currents, and hold each longer</source>
        <translation>使用更大且差别更大的电流，并各保持更久</translation>
    </message>
    <message>
        <source>the angle&apos;s column looks like a speed: it settles with each current instead of growing on</source>
        <translation>角度列看起来像转速：在每个电流下趋于定值，而不是继续增长</translation>
    </message>
    <message>
        <source>record the position, or rename the columns</source>
        <translation>记录位置，或重新命名各列</translation>
    </message>
    <message>
        <source>the angle wraps after {} deg: it was continued</source>
        <translation>角度在 {} 度后回绕：已将其接续</translation>
    </message>
    <message>
        <source>nothing is lost as long as the rotor turns less than half of that between two rows</source>
        <translation>只要转子在两行之间转过的角度小于其一半，就没有损失</translation>
    </message>
    <message>
        <source>the rotor turns against its current</source>
        <translation>转子逆着电流转动</translation>
    </message>
    <message>
        <source>the board&apos;s clock started again: the recording has a gap there, as long as this computer&apos;s clock says</source>
        <translation>控制板的时钟重新开始：记录在此处有一段间隙，长度按本机时钟计</translation>
    </message>
    <message>
        <source>the line damaged {} % of the frames</source>
        <translation>线路损坏了 {} % 的帧</translation>
    </message>
    <message>
        <source>shorten or shield the cable, or lower the baud rate</source>
        <translation>缩短或屏蔽电缆，或降低波特率</translation>
    </message>
    <message>
        <source>{} % of the packets were lost and none was damaged: a queue was full</source>
        <translation>丢失了 {} % 的数据包，没有损坏：某个队列已满</translation>
    </message>
    <message>
        <source>record fewer signals or at a lower rate, or connect by tcp: instead of udp:</source>
        <translation>减少记录的信号或降低速率，或用 tcp: 代替 udp: 连接</translation>
    </message>
    <message>
        <source>no packet was lost or damaged: the board left rows out or sent them late</source>
        <translation>没有数据包丢失或损坏：控制板漏发了行或发送过晚</translation>
    </message>
    <message>
        <source>record again; at most one row in ten may be lost</source>
        <translation>请重新记录；最多允许丢失十分之一的行</translation>
    </message>
    <message>
        <source>measure again</source>
        <translation>请重新测量</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>请重试。</translation>
    </message>
    <message>
        <source>A number of the spherical rotor is not finite.</source>
        <translation>球形转子的一个数值不是有限数。</translation>
    </message>
    <message>
        <source>The outer radius of the magnet must be larger than the radius of its core.</source>
        <translation>磁体的外半径必须大于其铁芯的半径。</translation>
    </message>
    <message>
        <source>Relative permeabilities of the rotor are at least 1.</source>
        <translation>转子的相对磁导率至少为 1。</translation>
    </message>
    <message>
        <source>The amplitude of a spherical harmonic is not a finite number.</source>
        <translation>球谐函数的幅值不是有限数。</translation>
    </message>
    <message>
        <source>A spherical harmonic needs a degree of 1 to 16 and an order of 0 to its degree.</source>
        <translation>球谐函数的阶数须为 1 到 16，级数须为 0 到该阶数。</translation>
    </message>
    <message>
        <source>A number of the stator coil is not finite.</source>
        <translation>定子线圈的一个数值不是有限数。</translation>
    </message>
    <message>
        <source>A stator coil needs a positive radius, turns and an axis of length one.</source>
        <translation>定子线圈需要正的半径、匝数和长度为 1 的轴向量。</translation>
    </message>
    <message>
        <source>A field sensor setting is not a finite number.</source>
        <translation>磁场传感器的一个设置不是有限数。</translation>
    </message>
    <message>
        <source>A field sensor needs positive gains, noise of at least zero and a range of at least two steps of its converter.</source>
        <translation>磁场传感器需要正的增益、不小于零的噪声，以及至少两个转换器步长的量程。</translation>
    </message>
    <message>
        <source>The pose of a field sensor is not a finite number.</source>
        <translation>磁场传感器的位姿不是有限数。</translation>
    </message>
    <message>
        <source>A field sensor lies inside the rotor.</source>
        <translation>一个磁场传感器位于转子内部。</translation>
    </message>
    <message>
        <source>Place it outside the rotor&apos;s outer radius.</source>
        <translation>请将其置于转子外半径之外。</translation>
    </message>
    <message>
        <source>The three axes of a field sensor must be unit vectors that span the space.</source>
        <translation>磁场传感器的三个轴必须是张成空间的单位向量。</translation>
    </message>
    <message>
        <source>Two field sensors lie at the same place.</source>
        <translation>两个磁场传感器位于同一位置。</translation>
    </message>
    <message>
        <source>Each of the three sensors needs a place of its own.</source>
        <translation>三个传感器各需一个不同的位置。</translation>
    </message>
    <message>
        <source>settling: the speed that it approaches</source>
        <translation>趋稳中：它所趋近的转速</translation>
    </message>
    <message>
        <source>there are no more stretches of motion than unknowns: how much friction differs between them is assumed, 3.3 % of its torque, and not measured</source>
        <translation>运动段数不多于未知数：各段之间摩擦的差异按其力矩的 3.3 % 假定，而非测得</translation>
    </message>
    <message>
        <source>record more run-ups and coast-downs at different currents, in both directions</source>
        <translation>以不同电流在两个方向上记录更多的加速和惯性减速</translation>
    </message>
    <message>
        <source>the cycle shows a damping below zero, which no motor has</source>
        <translation>振荡显示阻尼低于零，没有电机如此</translation>
    </message>
    <message>
        <source>calibrate the sensors; look for a delay that the board does not tell</source>
        <translation>请标定传感器；检查电路板未说明的延迟</translation>
    </message>
    <message>
        <source>the intervals do not hold that error: use the speeds that matter, warm the bearings up first, and look at the residuals</source>
        <translation>区间不包含这一误差：请使用实际关心的转速，先预热轴承，并查看残差</translation>
    </message>
    <message>
        <source>drag grows with the square of the speed, by {}</source>
        <translation>阻力随转速平方增大，系数为 {}</translation>
    </message>
    <message>
        <source>c, K_f and phi are those beside this term; the model that is used for tuning has no such drag</source>
        <translation>c、K_f 和 phi 是除该项之外的值；整定所用的模型没有这种阻力</translation>
    </message>
    <message>
        <source>friction falls with the speed (Stribeck): at {} rad/s it is higher by {}, above about {} rad/s it is constant</source>
        <translation>摩擦随转速下降（Stribeck）：在 {} rad/s 时高出 {}，约 {} rad/s 以上为常数</translation>
    </message>
    <message>
        <source>c, K_f and phi are those beside this term, at high speed; near standstill friction is higher</source>
        <translation>c、K_f 和 phi 是除该项之外、高转速时的值；接近静止时摩擦更高</translation>
    </message>
    <message>
        <source>model inadequate: the damping differs between the directions</source>
        <translation>模型不充分：两个方向的阻尼不同</translation>
    </message>
    <message>
        <source>the damping changes with the current: the angle of the torque moves with it, as a wrong compensation of the stray field moves it</source>
        <translation>阻尼随电流变化：转矩的角度随之移动，错误的杂散场补偿就会如此</translation>
    </message>
    <message>
        <source>phi is smaller than the true one by up to some per cent: calibrate the stray field, then identify again</source>
        <translation>phi 比真值最多小百分之几：请标定杂散场，然后重新辨识</translation>
    </message>
    <message>
        <source>model inadequate: the damping changes in the course of the recording</source>
        <translation>模型不充分：阻尼在记录过程中变化</translation>
    </message>
    <message>
        <source>model inadequate: friction depends on the speed as no known law does</source>
        <translation>模型不充分：摩擦随转速的变化不符合任何已知规律</translation>
    </message>
    <message>
        <source>the motion does not tell the forces apart</source>
        <translation>运动无法区分这些力</translation>
    </message>
    <message>
        <source>a coefficient of a filter is not a finite number</source>
        <translation>滤波器的某个系数不是有限数</translation>
    </message>
    <message>
        <source>the filter with a1 = {}, a2 = {} is not stable</source>
        <translation>a1 = {}、a2 = {} 的滤波器不稳定</translation>
    </message>
    <message>
        <source>a section is given as it is sampled</source>
        <translation>二阶节以采样形式给出</translation>
    </message>
    <message>
        <source>A number of the grid of poses is not finite.</source>
        <translation>位姿网格的一个数值不是有限数。</translation>
    </message>
    <message>
        <source>The grid of poses is empty.</source>
        <translation>位姿网格为空。</translation>
    </message>
    <message>
        <source>The grid has more than 200 million poses.</source>
        <translation>网格的位姿超过 2 亿个。</translation>
    </message>
    <message>
        <source>Make its step larger.</source>
        <translation>请增大其步长。</translation>
    </message>
    <message>
        <source>The proof of the coverage was stopped.</source>
        <translation>覆盖性证明已中止。</translation>
    </message>
    <message>
        <source>The box of the coverage proof is empty or its cells too small.</source>
        <translation>覆盖性证明的区域为空，或其单元过小。</translation>
    </message>
    <message>
        <source>The claimed placement is not on the lattice.</source>
        <translation>所声明的布置不在网格上。</translation>
    </message>
    <message>
        <source>The estimator needs harmonic passes of at least 0, at least one iteration and a positive limit of chi-square.</source>
        <translation>估计器需要球谐修正次数不小于 0、至少一次迭代，以及正的卡方限值。</translation>
    </message>
    <message>
        <source>The sensors do not determine the field of the rotor.</source>
        <translation>传感器无法确定转子的磁场。</translation>
    </message>
    <message>
        <source>Two of them need directions that differ and are not opposite.</source>
        <translation>其中两个的方向须不同，且不能相反。</translation>
    </message>
    <message>
        <source>The computation was stopped.</source>
        <translation>计算已中止。</translation>
    </message>
    <message>
        <source>A number of the rotor&apos;s motion is not finite.</source>
        <translation>转子运动的一个数值不是有限数。</translation>
    </message>
    <message>
        <source>The rotor&apos;s motion needs a positive rate, sample time and tilt of at most 180 degrees.</source>
        <translation>转子运动需要正的角速度、正的采样时间，以及不超过 180 度的正倾角。</translation>
    </message>
    <message>
        <source>The table of poses is empty.</source>
        <translation>位姿表为空。</translation>
    </message>
    <message>
        <source>the spherical motor has no parameter &apos;{}&apos;</source>
        <translation>球形电机没有参数“{}”</translation>
    </message>
    <message>
        <source>A number of the orientation sensing is not finite.</source>
        <translation>姿态测量的一个数值不是有限数。</translation>
    </message>
    <message>
        <source>The deviation of every field reading must be positive.</source>
        <translation>每个磁场读数的偏差必须为正。</translation>
    </message>
    <message>
        <source>The strength q of the rotor&apos;s field must be positive.</source>
        <translation>转子磁场的强度 q 必须为正。</translation>
    </message>
    <message>
        <source>A magnet poled the other way is the same one turned by 90 degrees about its shaft.</source>
        <translation>极性相反的磁体等同于绕其轴转过 90 度的同一磁体。</translation>
    </message>
    <message>
        <source>The reference radius of the rotor&apos;s field must be positive.</source>
        <translation>转子磁场的参考半径必须为正。</translation>
    </message>
    <message>
        <source>The estimators need harmonics of even degree and even order.</source>
        <translation>估计器需要阶数和级数均为偶数的球谐函数。</translation>
    </message>
    <message>
        <source>Others break the symmetry of the four-pole rotor.</source>
        <translation>其他球谐函数会破坏四极转子的对称性。</translation>
    </message>
    <message>
        <source>A setting of the particle swarm is not a finite number.</source>
        <translation>粒子群的一个设置不是有限数。</translation>
    </message>
    <message>
        <source>The box of the particle swarm is empty.</source>
        <translation>粒子群的搜索区域为空。</translation>
    </message>
    <message>
        <source>The particle swarm needs 1 to 128 particles and numbers of steps of at least 0.</source>
        <translation>粒子群需要 1 到 128 个粒子，且步数不小于 0。</translation>
    </message>
    <message>
        <source>Thresholds, pulls and stops of the particle swarm are at least zero, its limits of velocity and step positive.</source>
        <translation>粒子群的阈值、牵引系数和停止值不小于零，其速度和步长限值为正。</translation>
    </message>
    <message>
        <source>gains with set-point weights or filters are applied at once, not in small steps</source>
        <translation>带设定值权重或滤波器的增益一次性应用，不以小步进行</translation>
    </message>
    <message>
        <source>switch small steps off</source>
        <translation>请关闭小步方式</translation>
    </message>
    <message>
        <source>the law on the device has set-point weights or filters</source>
        <translation>设备中的控制律带有设定值权重或滤波器</translation>
    </message>
    <message>
        <source>apply the gains at once: that takes them out</source>
        <translation>请一次性应用增益：这会将其移除</translation>
    </message>
    <message>
        <source>set-point weight b</source>
        <translation>设定值权重 b</translation>
    </message>
    <message>
        <source>set-point weight c</source>
        <translation>设定值权重 c</translation>
    </message>
    <message>
        <source>filter on the derivative</source>
        <translation>微分滤波</translation>
    </message>
    <message>
        <source>filters in series</source>
        <translation>串联滤波器</translation>
    </message>
    <message>
        <source>more than {} filters in series</source>
        <translation>多于 {} 个的串联滤波器</translation>
    </message>
    <message>
        <source>the law of this board has no {}</source>
        <translation>此控制板的控制律不支持：{}</translation>
    </message>
    <message>
        <source>, no </source>
        <translation>、</translation>
    </message>
    <message>
        <source>take it out of the gains, or save the law as C code for another controller</source>
        <translation>请将其从增益中去掉，或把控制律保存为 C 代码供其他控制器使用</translation>
    </message>
    <message>
        <source>these gains need a board whose law has their set-point weights and filters</source>
        <translation>这些增益需要其控制律具有相应设定值权重和滤波器的控制板</translation>
    </message>
    <message>
        <source>tune --gains FILE --apply DEVICE says whether it has; else save the law as C code</source>
        <translation>tune --gains FILE --apply DEVICE 会说明它是否具有；否则请把控制律保存为 C 代码</translation>
    </message>
    <message>
        <source>The closed form of the additive model needs sensor 1 at (0, 0, 45 degrees).</source>
        <translation>相加模型的闭式解要求传感器 1 位于 (0, 0, 45 度)。</translation>
    </message>
</context>
<context>
    <name>halbench::app::ArmButton</name>
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
</context>
<context>
    <name>halbench::app::ArrangementNotice</name>
    <message>
        <source>The arrangement of the panels in %1 is damaged; the first one is shown.</source>
        <translation>%1 中的面板布局已损坏；显示初始布局。</translation>
    </message>
    <message>
        <source>The arrangement of the panels in %1 is from a newer version; the first one is shown.</source>
        <translation>%1 中的面板布局来自更新的版本；显示初始布局。</translation>
    </message>
    <message>
        <source>The arrangement of the panels in %1 is from an older version; the first one is shown.</source>
        <translation>%1 中的面板布局来自更旧的版本；显示初始布局。</translation>
    </message>
    <message>
        <source>Nothing of it is lost: it stays in the file under the name %1.</source>
        <translation>没有任何内容丢失：它以名称 %1 保留在文件中。</translation>
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
        <source>Ha&amp;ll sensors</source>
        <translation>霍尔传感器(&amp;L)</translation>
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
        <source>Static fr&amp;iction</source>
        <translation>静摩擦(&amp;I)</translation>
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
    <message>
        <source>What the Hall sensors read; centre, axes and tilt of the ellipse are measured</source>
        <translation>霍尔传感器的读数；测量椭圆的中心、轴长和倾角</translation>
    </message>
    <message>
        <source>It can be applied to the device it was measured on only; calibrate again when the sensors were touched.</source>
        <translation>只能应用于测量时的设备；传感器被动过后请重新标定。</translation>
    </message>
    <message>
        <source>Hall ellipse</source>
        <translation>霍尔椭圆</translation>
    </message>
    <message>
        <source>What the Hall sensors read, and the ellipse that was fitted to it</source>
        <translation>霍尔传感器的读数，以及据此拟合的椭圆</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>How far the readings lie outside of the ellipse, over the angle</source>
        <translation>读数偏出椭圆的距离随角度的变化</translation>
    </message>
    <message>
        <source>Static friction</source>
        <translation>静摩擦</translation>
    </message>
    <message>
        <source>Current at the first motion over the angle, both ways</source>
        <translation>首次运动时的电流随角度的变化（两个方向）</translation>
    </message>
    <message>
        <source>Pictures of the calibration</source>
        <translation>标定图形</translation>
    </message>
    <message>
        <source>The board has these values.</source>
        <translation>控制板已有这些值。</translation>
    </message>
    <message>
        <source>The board does not have these values yet: Apply writes them. Calibrate again when the sensors were touched.</source>
        <translation>控制板尚无这些值：“应用”会写入。如果碰过传感器，请重新标定。</translation>
    </message>
    <message>
        <source>On the device</source>
        <translation>设备上</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Applied and read back; it stays until the simulated device is disconnected.</source>
        <translation>已应用并回读；在仿真设备断开连接之前有效。</translation>
    </message>
    <message>
        <source>The rotor moves (Ctrl+Return); Esc stops it</source>
        <translation>转子会运动（Ctrl+Return）；按 Esc 键停止</translation>
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
        <source>device not known</source>
        <translation>设备未知</translation>
    </message>
    <message>
        <source>From the project: calibrated in virtual time, device %1.</source>
        <translation>来自项目：在虚拟时间内标定，设备 %1。</translation>
    </message>
    <message>
        <source>From the project: calibrated %1, device %2.</source>
        <translation>来自项目：标定时间 %1，设备 %2。</translation>
    </message>
    <message>
        <source>angle error, cosine part %1</source>
        <translation>角度误差，余弦分量 %1</translation>
    </message>
    <message>
        <source>angle error, sine part %1</source>
        <translation>角度误差，正弦分量 %1</translation>
    </message>
    <message>
        <source>angle error that the map takes away, rms</source>
        <translation>修正表消除的角度误差，均方根</translation>
    </message>
    <message>
        <source>breakaway current, from rest</source>
        <translation>起动电流，从静止开始</translation>
    </message>
    <message>
        <source>Residual angle error: %1 with the values from before, %2 with the proposed ones.</source>
        <translation>残余角度误差：原有值 %1，建议值 %2。</translation>
    </message>
    <message>
        <source>It is the root mean square (rms) over a turn of the distance between the angle that is read and that of the ellipse, before the map.</source>
        <translation>它是一转内读出角度与椭圆角度之差的均方根（rms），未经修正表。</translation>
    </message>
    <message>
        <source>The breakaway current is the one that starts the rotor from rest. Identify finds another figure: K_f/φ, the current that friction takes while it moves, usually less.</source>
        <translation>起动电流使转子从静止开始转动。辨识得到的是另一个量：K_f/φ，即转动时克服摩擦所需的电流，通常更小。</translation>
    </message>
    <message>
        <source>What is the difference?</source>
        <translation>有何区别？</translation>
    </message>
    <message>
        <source>The board ends the motion at %1 %2. Nothing is changed until you apply it.</source>
        <translation>转速达到 %1 %2 时控制板结束运动。应用之前不会更改任何内容。</translation>
    </message>
    <message>
        <source>Measured before the last connect, device %1.</source>
        <translation>上次连接之前测得，设备 %1。</translation>
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
    <message>
        <source>fitted ellipse</source>
        <translation>拟合椭圆</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Hall B</source>
        <translation>霍尔 B</translation>
    </message>
    <message>
        <source>Hall readings and their ellipse</source>
        <translation>霍尔读数及其椭圆</translation>
    </message>
    <message>
        <source>Hall A</source>
        <translation>霍尔 A</translation>
    </message>
    <message>
        <source>reading minus ellipse</source>
        <translation>读数减椭圆</translation>
    </message>
    <message>
        <source>What the ellipse leaves over</source>
        <translation>椭圆未能解释的部分</translation>
    </message>
</context>
<context>
    <name>halbench::app::ConfigurationPanel</name>
    <message>
        <source>Save settings …</source>
        <translation>保存设置 …</translation>
    </message>
    <message>
        <source>Writes all settings of the device into a file</source>
        <translation>将设备的所有设置写入文件</translation>
    </message>
    <message>
        <source>Compare with …</source>
        <translation>比较 …</translation>
    </message>
    <message>
        <source>Shows a file beside the device; nothing is written yet</source>
        <translation>将文件与设备并列显示；尚不写入</translation>
    </message>
    <message>
        <source>No configuration file is open</source>
        <translation>没有打开配置文件</translation>
    </message>
    <message>
        <source>A file shows row by row what differs from the device, to restore what you tick. Before that, what the device has is kept.</source>
        <translation>文件逐行显示与设备的不同之处，恢复您勾选的项。恢复前会保留设备现有的值。</translation>
    </message>
    <message>
        <source>Compare with a file …</source>
        <translation>与文件比较 …</translation>
    </message>
    <message>
        <source>Only what &amp;differs</source>
        <translation>仅不同项(&amp;D)</translation>
    </message>
    <message>
        <source>Hides rows that are the same or not in the file</source>
        <translation>隐藏相同的行或文件中没有的行</translation>
    </message>
    <message>
        <source>With &amp;calibration</source>
        <translation>含标定(&amp;C)</translation>
    </message>
    <message>
        <source>Ticks what was measured on one device; measured on another device, it is wrong on this one</source>
        <translation>勾选在某台设备上测得的值；若在另一台设备上测得，则对此设备是错误的</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Writes the ticked rows in one step and reads them back; they last until power-down unless they are saved in the device</source>
        <translation>一步写入勾选的行并读回；若不保存到设备，断电后丢失</translation>
    </message>
    <message numerus="yes">
        <source>Restore %n row(s)</source>
        <translation>
            <numerusform>恢复 %n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>Save settings</source>
        <translation>保存设置</translation>
    </message>
    <message>
        <source>Configuration (*.toml)</source>
        <translation>配置 (*.toml)</translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) saved.</source>
        <translation>
            <numerusform>已保存 %n 项设置。</numerusform>
        </translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>%1: device %2, firmware %3, written %4</source>
        <translation>%1：设备 %2，固件 %3，写于 %4</translation>
    </message>
    <message>
        <source>What the device had before is kept in %1.</source>
        <translation>设备原有的值保存在 %1。</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) not restored; the rows say why.</source>
        <translation>
            <numerusform>%n 行未恢复；各行说明了原因。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) restored and read back.</source>
        <translation>
            <numerusform>已恢复并读回 %n 行。</numerusform>
        </translation>
    </message>
    <message>
        <source>They last until power-down; Save in the device, in Parameters, keeps them.</source>
        <translation>断电前有效；用“参数”中的“保存到设备”可长期保留。</translation>
    </message>
    <message>
        <source>configuration</source>
        <translation>配置</translation>
    </message>
</context>
<context>
    <name>halbench::app::ConfigurationTable</name>
    <message>
        <source>Rows of the configuration</source>
        <translation>配置的各行</translation>
    </message>
    <message>
        <source>Ticked rows are restored (Space ticks); numbers are in SI units, as in the file</source>
        <translation>勾选的行将被恢复（空格键勾选）；数值为 SI 单位，与文件一致</translation>
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
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>restored</source>
        <translation>已恢复</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>相同</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>不同</translation>
    </message>
    <message>
        <source>not in the file</source>
        <translation>文件中没有</translation>
    </message>
    <message>
        <source>not restored</source>
        <translation>未恢复</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>differs, and was measured on one device: wrong on another</source>
        <translation>不同，且是在某台设备上测得的：对另一台是错误的</translation>
    </message>
</context>
<context>
    <name>halbench::app::ConnectButton</name>
    <message>
        <source>Connect</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>断开</translation>
    </message>
    <message>
        <source>Connect the device of the Devices panel; the menu lists what is there (Ctrl+Shift+C, Alt+Down)</source>
        <translation>连接“设备”面板中的设备；菜单列出现有设备 (Ctrl+Shift+C, Alt+Down)</translation>
    </message>
    <message>
        <source>End what runs, disarm and disconnect (Ctrl+Shift+C)</source>
        <translation>结束正在运行的任务、解除使能并断开 (Ctrl+Shift+C)</translation>
    </message>
    <message>
        <source>End the search for the device (Ctrl+Shift+C)</source>
        <translation>结束查找设备 (Ctrl+Shift+C)</translation>
    </message>
</context>
<context>
    <name>halbench::app::DepartureWords</name>
    <message>
        <source>It ended because the connection to the device was lost: %1.</source>
        <translation>因与设备的连接丢失而结束：%1。</translation>
    </message>
    <message>
        <source>The board&apos;s watchdog disarms it by itself. Begin anew when it is connected again.</source>
        <translation>控制板的看门狗会自行解除使能。重新连接后请再次开始。</translation>
    </message>
    <message>
        <source>It ended because the device was disconnected.</source>
        <translation>因设备已断开而结束。</translation>
    </message>
    <message>
        <source>The board was disarmed first, and everything on it is as it was before. Begin anew when it is connected again.</source>
        <translation>已先解除控制板的使能，其上一切恢复原状。重新连接后请再次开始。</translation>
    </message>
</context>
<context>
    <name>halbench::app::DerivedPanel</name>
    <message>
        <source>What is wrong with the expression</source>
        <translation>表达式的错误</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>表达式</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Derived signals</source>
        <translation>派生信号</translation>
    </message>
    <message>
        <source>Enter takes a row into the fields above, Delete removes it</source>
        <translation>按 Enter 把一行取到上方，按 Delete 删除</translation>
    </message>
    <message>
        <source>As it shall stand in the tree: letters, digits, dots, underscores</source>
        <translation>在树中的名称：字母、数字、点、下划线</translation>
    </message>
    <message>
        <source>Of names of signals in SI units, e.g. current.a^2 + current.b^2; + - * / ^, sin, cos, atan2, sqrt, abs, exp, ln, min, max, pi. Enter keeps it</source>
        <translation>由信号名称组成（SI 单位），例如 current.a^2 + current.b^2；+ - * / ^、sin、cos、atan2、sqrt、abs、exp、ln、min、max、pi。按 Enter 保留</translation>
    </message>
    <message>
        <source>Of the value; empty: as it follows from the expression. A symbol such as rad, rad/s, T, A, degC is shown in the preferred unit</source>
        <translation>数值的单位；留空则由表达式推出。rad、rad/s、T、A、degC 等符号按首选单位显示</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Computes the signal from now on (Enter)</source>
        <translation>从现在起计算该信号 (Enter)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Removes the signal that is chosen below (Delete)</source>
        <translation>删除下方所选的信号 (Delete)</translation>
    </message>
    <message>
        <source>waits for a device</source>
        <translation>等待设备</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>已计算</translation>
    </message>
</context>
<context>
    <name>halbench::app::DesignNames</name>
    <message>
        <source>recommended</source>
        <translation>推荐</translation>
    </message>
    <message>
        <source>pole placement</source>
        <translation>极点配置</translation>
    </message>
    <message>
        <source>bandwidth</source>
        <translation>带宽</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>SIMC</source>
        <translation>SIMC</translation>
    </message>
    <message>
        <source>lambda</source>
        <translation>Lambda</translation>
    </message>
    <message>
        <source>Ziegler-Nichols PID</source>
        <translation>Ziegler-Nichols PID</translation>
    </message>
    <message>
        <source>Ziegler-Nichols PI</source>
        <translation>Ziegler-Nichols PI</translation>
    </message>
    <message>
        <source>Ziegler-Nichols P</source>
        <translation>Ziegler-Nichols P</translation>
    </message>
    <message>
        <source>LQR</source>
        <translation>LQR</translation>
    </message>
    <message>
        <source>least IAE</source>
        <translation>最小 IAE</translation>
    </message>
    <message>
        <source>least ITAE</source>
        <translation>最小 ITAE</translation>
    </message>
    <message>
        <source>lead</source>
        <translation>超前 (PD)</translation>
    </message>
    <message>
        <source>lag</source>
        <translation>滞后 (PI)</translation>
    </message>
    <message>
        <source>published</source>
        <translation>已发表</translation>
    </message>
    <message>
        <source>designed</source>
        <translation>设计值</translation>
    </message>
    <message>
        <source>micro-step</source>
        <translation>微步</translation>
    </message>
    <message>
        <source>published, in degrees</source>
        <translation>已发表，按度</translation>
    </message>
    <message>
        <source>from the device</source>
        <translation>来自设备</translation>
    </message>
    <message>
        <source>edited by hand</source>
        <translation>手动编辑</translation>
    </message>
</context>
<context>
    <name>halbench::app::DesignTable</name>
    <message>
        <source>stable</source>
        <translation>稳定</translation>
    </message>
    <message>
        <source>UNSTABLE</source>
        <translation>不稳定</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>当前建议</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>幅值裕度</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>Delay margin</source>
        <translation>时延裕度</translation>
    </message>
    <message>
        <source>Bandwidth</source>
        <translation>带宽</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>Closed loop</source>
        <translation>闭环</translation>
    </message>
    <message>
        <source>Designs compared</source>
        <translation>设计比较</translation>
    </message>
    <message>
        <source>A tick draws the design in the pictures (Space), F2 renames it, Del removes it</source>
        <translation>勾选后在图中绘出该设计（空格），F2 重命名，Del 移除</translation>
    </message>
    <message>
        <source>Keep this design</source>
        <translation>保留此设计</translation>
    </message>
    <message>
        <source>The proposed gains stay in the project, under a name of their own</source>
        <translation>建议的增益以自己的名称保留在项目中</translation>
    </message>
    <message>
        <source>Take up</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>The gains of the chosen design become the proposed ones</source>
        <translation>所选设计的增益成为建议的增益</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>The chosen design leaves the project</source>
        <translation>所选设计从项目中移除</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>What was last done to the list of designs is taken back (Ctrl+Z)</source>
        <translation>撤回对设计列表的最近一次操作（Ctrl+Z）</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>What was taken back is done again (Ctrl+Shift+Z)</source>
        <translation>重新执行已撤回的操作（Ctrl+Shift+Z）</translation>
    </message>
    <message>
        <source>%1, with filters</source>
        <translation>%1，带滤波</translation>
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
    <message>
        <source>Ending what runs and disarming …</source>
        <translation>正在结束运行中的任务并解除使能 …</translation>
    </message>
    <message>
        <source>%1, last used</source>
        <translation>%1，上次使用</translation>
    </message>
    <message>
        <source>End the search for the device (Alt+C)</source>
        <translation>结束查找设备 (Alt+C)</translation>
    </message>
    <message>
        <source>Connection lost. Looking for %1 …</source>
        <translation>连接已断开。正在查找 %1 …</translation>
    </message>
    <message>
        <source>Description of the board</source>
        <translation>控制板描述</translation>
    </message>
    <message>
        <source>Description (*.a2l)</source>
        <translation>描述 (*.a2l)</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>未说明</translation>
    </message>
    <message>
        <source>Description file…</source>
        <translation>描述文件…</translation>
    </message>
    <message>
        <source>Description file of a board that does not describe itself: the A2L file that its maker gives with it</source>
        <translation>用于不自带描述的控制板的描述文件：制造商随附的 A2L 文件</translation>
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
    <message>
        <source>%1 more lines came too fast to be shown</source>
        <translation>另有 %1 行到达过快，未能显示</translation>
    </message>
    <message>
        <source>%1 is back after %2 s, disarmed</source>
        <translation>%1 在 %2 s 后恢复连接，处于未使能状态</translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) came faster than the window could show them and are not drawn</source>
        <translation>
            <numerusform>%Ln 行到达过快，窗口来不及显示，因此未绘制</numerusform>
        </translation>
    </message>
    <message>
        <source>armed: it is disarmed before it is left</source>
        <translation>已使能：断开前先解除使能</translation>
    </message>
</context>
<context>
    <name>halbench::app::DisplayQuantity</name>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>转矩</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>length</source>
        <translation>长度</translation>
    </message>
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
    <message>
        <source>ratio</source>
        <translation>比值</translation>
    </message>
    <message>
        <source>rev</source>
        <translation>r</translation>
    </message>
    <message>
        <source>rev/s</source>
        <translation>r/s</translation>
    </message>
</context>
<context>
    <name>halbench::app::DockMenu</name>
    <message>
        <source>Puts the panel into a window of its own, with a STOP of its own, or back where it was</source>
        <translation>把面板移入单独的窗口（带有自己的停止按钮），或放回原处</translation>
    </message>
    <message>
        <source>Moves the panel behind the next one on that side, or along that edge of the window</source>
        <translation>把面板移到该侧的下一个面板处，或移到窗口的该侧边缘</translation>
    </message>
    <message>
        <source>Move &amp;left</source>
        <translation>左移(&amp;L)</translation>
    </message>
    <message>
        <source>Move &amp;right</source>
        <translation>右移(&amp;R)</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>上移(&amp;U)</translation>
    </message>
    <message>
        <source>Move &amp;down</source>
        <translation>下移(&amp;D)</translation>
    </message>
    <message>
        <source>Changes the size of the panel, at the expense of what is beside it</source>
        <translation>改变面板的大小，相邻部分随之变化</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>加宽(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Narrower</source>
        <translation>变窄(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Taller</source>
        <translation>加高(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Arrange the panel</source>
        <translation>排列面板(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Arrange the panel “%1”</source>
        <translation>排列面板“%1”(&amp;A)</translation>
    </message>
    <message>
        <source>Dock it &amp;back</source>
        <translation>放回(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Float in its own window</source>
        <translation>浮动为单独的窗口(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Shorter</source>
        <translation>变矮(&amp;S)</translation>
    </message>
</context>
<context>
    <name>halbench::app::DocumentFiles</name>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Picture (*.svg *.pdf *.png)</source>
        <translation>图片 (*.svg *.pdf *.png)</translation>
    </message>
    <message>
        <source>Its numbers (*.csv)</source>
        <translation>图中的数值 (*.csv)</translation>
    </message>
</context>
<context>
    <name>halbench::app::DriveControl</name>
    <message>
        <source>Not started: this firmware (%1) begins where it was armed, so the rotor would leap.</source>
        <translation>未启动：此固件 (%1) 会从使能处开始，转子会突跳。</translation>
    </message>
    <message>
        <source>Disarm and arm, then start. Firmware from 0.2.0 on goes on from where it holds.</source>
        <translation>请先解除使能再使能，然后启动。0.2.0 及以后的固件会从保持处继续。</translation>
    </message>
    <message>
        <source>Not sent: a reference runs, and more than %1° at once is a leap.</source>
        <translation>未发送：参考信号正在运行，一次超过 %1° 即为跳变。</translation>
    </message>
    <message>
        <source>Not sent: more than %1° at once is a leap, and the firmware of this board makes no ramp of it.</source>
        <translation>未发送：一次超过 %1° 即为跳变，而此控制板的固件不会将其变为斜坡。</translation>
    </message>
    <message>
        <source>End the reference first; then the board goes there as an even ramp.</source>
        <translation>请先结束参考信号；之后控制板会以匀速斜坡前往。</translation>
    </message>
    <message>
        <source>Go there in smaller steps, or jog. Firmware from 0.2.0 on makes a ramp.</source>
        <translation>请分成较小的步前往，或使用点动。0.2.0 及以后的固件会使用斜坡。</translation>
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
        <source>&apos;%1&apos; is not a limit, nothing was written.</source>
        <translation>“%1”不是限值，未写入任何内容。</translation>
    </message>
    <message>
        <source>Enter writes it; until power-down, unless it is saved in the device</source>
        <translation>按 Enter 写入；断电前有效，除非保存到设备</translation>
    </message>
</context>
<context>
    <name>halbench::app::DrivePanel</name>
    <message>
        <source>Drive it from the command line. STOP, Signals, Parameters and Record work here.</source>
        <translation>请用命令行驱动。停止、信号、参数和记录在此可用。</translation>
    </message>
    <message>
        <source>This device has several axes: it is not armed or driven from here.</source>
        <translation>此设备有多个轴：不能从此处使能或驱动。</translation>
    </message>
    <message>
        <source>What the board says of itself</source>
        <translation>控制板报告的自身状态</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>模式(&amp;M)</translation>
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
        <source>Set-point</source>
        <translation>设定值</translation>
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
        <source>A stop came while nothing was armed</source>
        <translation>停止到来时没有任何设备使能</translation>
    </message>
    <message>
        <source>%1 is beyond the excursion window, nothing was sent.</source>
        <translation>%1 超出偏移窗口，未发送任何内容。</translation>
    </message>
    <message>
        <source>From %1 to %2 now. Widen the window on purpose, or disarm and arm to count anew.</source>
        <translation>当前为 %1 至 %2。请有意放宽窗口，或解除使能后再使能以重新计数。</translation>
    </message>
    <message>
        <source>Armed, %1</source>
        <translation>已使能，%1</translation>
    </message>
    <message>
        <source>They last until power-down; Save in the device, in Parameters, keeps them.</source>
        <translation>断电前有效；用“参数”中的“保存到设备”可长期保留。</translation>
    </message>
    <message>
        <source>This device cannot be armed, driven or stopped from here: it has no parameter hb.arm.</source>
        <translation>无法从这里使能、驱动或停止此设备：它没有参数 hb.arm。</translation>
    </message>
    <message>
        <source>Use its maker&apos;s program and the switch at the actuator. Signals, Parameters and Record work with it by name.</source>
        <translation>请使用其制造商的程序和执行器上的开关。“信号”、“参数”和“记录”可按名称使用。</translation>
    </message>
    <message>
        <source>Not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Now %1, beside %2 by jog or reference</source>
        <translation>当前 %1，另加点动或参考信号的 %2</translation>
    </message>
    <message>
        <source>Sends the set-point zero: steps back %1</source>
        <translation>发送零设定值：跳回 %1</translation>
    </message>
    <message>
        <source>Sends the set-point zero: moves back %1 at the jog speed</source>
        <translation>发送零设定值：以点动转速返回 %1</translation>
    </message>
    <message>
        <source>Sends the set-point (Enter in the field); more than 30° away it
is approached as an even ramp at the jog speed</source>
        <translation>发送设定值（在输入框中按回车键）；若相距超过 30°，
则以点动转速按匀速斜坡前往</translation>
    </message>
    <message>
        <source>Waits for a sample of the angle.</source>
        <translation>等待一个角度采样值。</translation>
    </message>
    <message>
        <source>Beside what a reference has moved it (Enter sends it)</source>
        <translation>不含参考信号已移动的部分（按 Enter 发送）</translation>
    </message>
    <message>
        <source>Starts the reference from where the rotor is held: each start adds
its way to the one before (Ctrl+Shift+R)</source>
        <translation>从转子被保持的位置启动参考信号：
每次启动的行程都加在前一次之上 (Ctrl+Shift+R)</translation>
    </message>
    <message>
        <source> (at %1)</source>
        <translation>（%1）</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Angle from where it will be armed</source>
        <translation>从将使能处算起的角度</translation>
    </message>
    <message>
        <source>Angle from where the mode was chosen</source>
        <translation>从选择模式处算起的角度</translation>
    </message>
    <message>
        <source>Angle from where it was armed</source>
        <translation>从使能处算起的角度</translation>
    </message>
    <message>
        <source>Moves up to %1 from where it is, then up to %2 from where it was armed.</source>
        <translation>从当前位置最多运动 %1，届时距使能处最多 %2。</translation>
    </message>
    <message>
        <source>Start waits until this motion has ended, or End ends it.</source>
        <translation>“启动”须等此运动结束，或用“结束”终止它。</translation>
    </message>
</context>
<context>
    <name>halbench::app::DriveWords</name>
    <message>
        <source>reference</source>
        <translation>参考信号</translation>
    </message>
    <message>
        <source>step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>正弦</translation>
    </message>
    <message>
        <source>staircase</source>
        <translation>阶梯</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>扫频</translation>
    </message>
    <message>
        <source>multisine</source>
        <translation>多正弦</translation>
    </message>
    <message>
        <source>plateaus</source>
        <translation>平台</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>d-axis</source>
        <translation>D 轴</translation>
    </message>
    <message>
        <source>jogging</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%2上的%1</translation>
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
    <message>
        <source>A converter that drives a coil does not answer</source>
        <translation>驱动线圈的转换器没有响应</translation>
    </message>
    <message>
        <source>Look at the board&apos;s cables and supply, then release the stop.</source>
        <translation>请检查控制板的电缆和电源，然后解除停止。</translation>
    </message>
    <message>
        <source>by command</source>
        <translation>由命令</translation>
    </message>
    <message>
        <source>by the watchdog</source>
        <translation>由看门狗</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>已停止：%1</translation>
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
    <name>halbench::app::FilterEditor</name>
    <message>
        <source>Edit %1</source>
        <translation>编辑 %1</translation>
    </message>
    <message>
        <source>Add a filter</source>
        <translation>添加滤波器</translation>
    </message>
    <message>
        <source>Choose the kind of filter %1</source>
        <translation>选择滤波器 %1 的类型</translation>
    </message>
    <message>
        <source>Remove a filter</source>
        <translation>移除滤波器</translation>
    </message>
    <message>
        <source>a number is missing</source>
        <translation>缺少数值</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Write a number within its range</source>
        <translation>请写一个在其范围内的数</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>超前</translation>
    </message>
    <message>
        <source>Lag</source>
        <translation>滞后</translation>
    </message>
    <message>
        <source>Notch</source>
        <translation>陷波</translation>
    </message>
    <message>
        <source>Low-pass</source>
        <translation>低通</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>相位</translation>
    </message>
    <message>
        <source>Gain at rest</source>
        <translation>静态增益</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>转折频率</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>阶数</translation>
    </message>
    <message>
        <source>Filter %1</source>
        <translation>滤波器 %1</translation>
    </message>
    <message>
        <source>%1: kind</source>
        <translation>%1：类型</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除%1</translation>
    </message>
    <message>
        <source>Weights and filters</source>
        <translation>权重与滤波器</translation>
    </message>
    <message>
        <source>In series with the others, four at most; a low-pass at first</source>
        <translation>与其他滤波器串联，最多四个；起初为低通</translation>
    </message>
    <message>
        <source>Weight b of the set-point</source>
        <translation>设定值权重 b</translation>
    </message>
    <message>
        <source>Of K_P: below 1 a step is answered more gently</source>
        <translation>作用于 K_P：小于 1 时对阶跃的响应更柔和</translation>
    </message>
    <message>
        <source>Weight c of the set-point</source>
        <translation>设定值权重 c</translation>
    </message>
    <message>
        <source>Filter on the derivative</source>
        <translation>微分滤波</translation>
    </message>
    <message>
        <source>Where the phase is added; the gain there stays</source>
        <translation>在此处增加相位；该处增益不变</translation>
    </message>
    <message>
        <source>Added at that frequency</source>
        <translation>在该频率处增加的相位</translation>
    </message>
    <message>
        <source>Far above it the gain stays</source>
        <translation>远高于它处增益不变</translation>
    </message>
    <message>
        <source>Factor on the gain at rest, above 1</source>
        <translation>静态增益的倍数，大于 1</translation>
    </message>
    <message>
        <source>Where the gain is least</source>
        <translation>增益最小处</translation>
    </message>
    <message>
        <source>Factor on the gain at that frequency, 0 to 1</source>
        <translation>该频率处增益的倍数，0 到 1</translation>
    </message>
    <message>
        <source>Of its poles: the more, the wider it is</source>
        <translation>其极点的阻尼：越大则越宽</translation>
    </message>
    <message>
        <source>There the gain has fallen by 3 dB</source>
        <translation>该处增益下降 3 dB</translation>
    </message>
    <message>
        <source>1 or 2</source>
        <translation>1 或 2</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>二阶节</translation>
    </message>
    <message>
        <source>Coefficient of (b0 d² + b1 d + b2)/(d² + a1 d + a2), d = z − 1</source>
        <translation>(b0 d² + b1 d + b2)/(d² + a1 d + a2) 的系数，d = z − 1</translation>
    </message>
    <message>
        <source>Coefficient of d in the numerator</source>
        <translation>分子中 d 的系数</translation>
    </message>
    <message>
        <source>Coefficient of 1 in the numerator</source>
        <translation>分子中的常数项</translation>
    </message>
    <message>
        <source>Coefficient of d in the denominator; 0: no memory</source>
        <translation>分母中 d 的系数；0：无记忆</translation>
    </message>
    <message>
        <source>Coefficient of 1 in the denominator</source>
        <translation>分母中的常数项</translation>
    </message>
    <message>
        <source>Lead: phase at a frequency. Lag: more gain at rest. Notch: little gain at a frequency. Low-pass: little gain above a frequency. Section: by coefficients</source>
        <translation>超前：在某一频率处增加相位。滞后：静态增益更大。陷波：在某一频率处增益很小。低通：在某一频率以上增益很小。二阶节：由系数给出</translation>
    </message>
    <message>
        <source>Set-point weights, derivative filter and filters in series</source>
        <translation>设定值权重、微分滤波和串联滤波器</translation>
    </message>
    <message>
        <source>Applied to boards whose law offers them; else judged, compared and saved.</source>
        <translation>控制板的控制律支持时可应用；否则可评判、比较和保存。</translation>
    </message>
    <message>
        <source>Of K_D: 0 ignores a step of the set-point, 1 sees all of it</source>
        <translation>作用于 K_D：0 忽略设定值的阶跃，1 完全计入</translation>
    </message>
    <message>
        <source>Time constant; 0: the difference of two samples</source>
        <translation>时间常数；0：两个样本的差分</translation>
    </message>
</context>
<context>
    <name>halbench::app::ForeignMotorNotice</name>
    <message>
        <source>Apply gains of another motor here</source>
        <translation>在此应用另一台电机的增益</translation>
    </message>
    <message>
        <source>They were designed for a motor that this device may not be</source>
        <translation>这些增益是为另一台电机设计的，可能不是本设备</translation>
    </message>
    <message>
        <source>Whose motor is tuned</source>
        <translation>正在整定哪台电机</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyFigures</name>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>幅值裕度</translation>
    </message>
    <message>
        <source>Measured open loop</source>
        <translation>实测开环</translation>
    </message>
    <message>
        <source>Measured plant: angle over current, rad/A</source>
        <translation>实测对象：角度/电流，rad/A</translation>
    </message>
    <message>
        <source>Measured closed loop</source>
        <translation>实测闭环</translation>
    </message>
    <message>
        <source>coherence</source>
        <translation>相干性</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>measured, not coherent</source>
        <translation>实测，不相干</translation>
    </message>
    <message>
        <source>95 % of it</source>
        <translation>其 95 % 范围</translation>
    </message>
    <message>
        <source>rotor that fits</source>
        <translation>拟合的转子</translation>
    </message>
    <message>
        <source>The excitation as recorded</source>
        <translation>记录的激励</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>reference speed</source>
        <translation>参考转速</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>转速</translation>
    </message>
    <message>
        <source>current amplitude</source>
        <translation>电流幅值</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyForm</name>
    <message>
        <source>multisine: many frequencies at once</source>
        <translation>多正弦：多个频率同时</translation>
    </message>
    <message>
        <source>stepped sine: one after the other</source>
        <translation>步进正弦：逐个频率</translation>
    </message>
    <message>
        <source>chirp: swept again and again</source>
        <translation>扫频：反复扫过</translation>
    </message>
    <message>
        <source>E&amp;xcitation</source>
        <translation>激励(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Base speed</source>
        <translation>基础转速(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Periods</source>
        <translation>周期数(&amp;P)</translation>
    </message>
    <message>
        <source>What is added to the steady motion</source>
        <translation>叠加在匀速运动上的信号</translation>
    </message>
    <message>
        <source>A period of the excitation lasts as long as four of it</source>
        <translation>激励的一个周期等于它的四个周期</translation>
    </message>
    <message>
        <source>At most 45 % of the rate of the position loop</source>
        <translation>至多为位置环采样率的 45 %</translation>
    </message>
    <message>
        <source>Steady speed below the excitation, at least 3 rad/s in either direction: friction is then a plain offset</source>
        <translation>激励之下的匀速，任一方向至少 3 rad/s：这样摩擦只是一个偏置</translation>
    </message>
    <message>
        <source>That are averaged, of a chirp sweeps; the circles of confidence shrink with their root</source>
        <translation>用于平均的周期数，扫频时为扫频次数；置信圆随其平方根缩小</translation>
    </message>
    <message>
        <source>Points below it are shown faint and are part of no margin and no fit</source>
        <translation>低于它的点淡显，不参与任何裕度和拟合</translation>
    </message>
    <message>
        <source>Of a sine of the same rms, in every band. Empty: as large as is safe</source>
        <translation>各频带中相同有效值正弦的幅值。留空：在安全范围内尽可能大</translation>
    </message>
    <message>
        <source>as large as is safe</source>
        <translation>安全范围内尽可能大</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Write the number anew</source>
        <translation>请重新输入该数</translation>
    </message>
    <message>
        <source>Lowest frequency</source>
        <translation>最低频率</translation>
    </message>
    <message>
        <source>Highest frequency</source>
        <translation>最高频率</translation>
    </message>
    <message>
        <source>Least coherence</source>
        <translation>最小相干性</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>幅值</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyPanel</name>
    <message>
        <source>Save response</source>
        <translation>保存响应</translation>
    </message>
    <message>
        <source>Response (*.json)</source>
        <translation>频率响应 (*.json)</translation>
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
        <translation>拟合</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Measures the loop with the gains on the board, frequency by frequency: open loop, plant and margins with their 95 % intervals, on top of a steady motion that never turns back.</source>
        <translation>用控制板上的增益逐频率测量回路：开环、被控对象以及带 95 % 区间的裕度，叠加在从不反转的匀速运动上。</translation>
    </message>
    <message>
        <source>The rotor turns steadily and is excited. STOP (Esc) and Cancel end it; mode, windows and generator are restored, the gains stay as they are.</source>
        <translation>转子匀速转动并受到激励。“停止”（Esc）和“取消”结束测量；模式、窗口和信号发生器会恢复，增益保持不变。</translation>
    </message>
    <message>
        <source>Start measurement</source>
        <translation>开始测量</translation>
    </message>
    <message>
        <source>The rotor turns (Ctrl+Return); Esc stops it</source>
        <translation>转子会转动 (Ctrl+Return)；按 Esc 键停止</translation>
    </message>
    <message>
        <source>Use in Tune</source>
        <translation>用于整定</translation>
    </message>
    <message>
        <source>Draw the measured points into the open loop of Tune, with the gains proposed there</source>
        <translation>以整定中建议的增益，把实测点画入其开环</translation>
    </message>
    <message>
        <source>Save response…</source>
        <translation>保存响应…</translation>
    </message>
    <message>
        <source>Write the file that Tune and the program read</source>
        <translation>写出整定和程序可读取的文件</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>保存表格…</translation>
    </message>
    <message>
        <source>Write the points with error and coherence as CSV</source>
        <translation>将各点连同误差和相干性写为 CSV</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>重新测量</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next one</source>
        <translation>返回设置；此结果保留到下一次</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>频率响应</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>Computing the response</source>
        <translation>正在计算频率响应</translation>
    </message>
    <message>
        <source>The measurement was cancelled; everything is as it was before.</source>
        <translation>测量已取消；一切恢复原状。</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>保存表格</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyResultView</name>
    <message>
        <source>Margins and fitted rotor</source>
        <translation>裕度与拟合的转子</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>开环</translation>
    </message>
    <message>
        <source>With the gains on the board: magnitude, phase and coherence over one frequency</source>
        <translation>用控制板上的增益：同一频率轴上的幅值、相位和相干性</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>被控对象</translation>
    </message>
    <message>
        <source>From the current to the measured angle, with the rotor that fits</source>
        <translation>从电流到实测角度，以及拟合的转子</translation>
    </message>
    <message>
        <source>Closed loop</source>
        <translation>闭环</translation>
    </message>
    <message>
        <source>From the reference to the measured angle</source>
        <translation>从参考到实测角度</translation>
    </message>
    <message>
        <source>Raw record</source>
        <translation>原始记录</translation>
    </message>
    <message>
        <source>Speed and current over time, as recorded</source>
        <translation>记录的转速和电流随时间的变化</translation>
    </message>
    <message>
        <source>Pictures of the frequency response</source>
        <translation>频率响应的图形</translation>
    </message>
</context>
<context>
    <name>halbench::app::FrequencyWords</name>
    <message>
        <source>withheld: crosses nowhere</source>
        <translation>不予给出：无穿越</translation>
    </message>
    <message>
        <source>withheld: crosses in a gap</source>
        <translation>不予给出：在空缺处穿越</translation>
    </message>
    <message>
        <source>withheld: too uncertain</source>
        <translation>不予给出：不确定性过大</translation>
    </message>
    <message>
        <source>The findings above say why, and what helps</source>
        <translation>上面的诊断说明原因和办法</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>where the loop crosses, at %1 Hz</source>
        <translation>回路在 %1 Hz 处穿越</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>The rotor will turn in reverse at %1 rad/s (%2 r/min), about %3 turns, for %4 minutes of device time.</source>
        <translation>转子将以 %1 rad/s（%2 r/min）反转，约 %3 转，设备时间 %4 分钟。</translation>
    </message>
    <message>
        <source>The rotor will turn forward at %1 rad/s (%2 r/min), about %3 turns, for %4 minutes of device time.</source>
        <translation>转子将以 %1 rad/s（%2 r/min）正转，约 %3 转，设备时间 %4 分钟。</translation>
    </message>
    <message>
        <source>On top of that it is excited by up to %1°; its speed never changes sign, and the run ends where it comes near zero.</source>
        <translation>在此之上激励至多 %1°；其转速从不变号，一旦接近零即结束运行。</translation>
    </message>
    <message>
        <source>The board ends the motion at %1 rad/s. The gains on the board stay and are measured with; all else is restored whatever happens.</source>
        <translation>控制板在 %1 rad/s 时结束运动。控制板上的增益保持不变并用于测量；其余一切无论如何都会恢复。</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>gain margin</source>
        <translation>幅值裕度</translation>
    </message>
    <message>
        <source>angle that follows the current at once</source>
        <translation>立即随电流变化的角度</translation>
    </message>
    <message>
        <source>%1 of %2 frequencies have a coherence of %3 or more; the others are faint and part of no margin and no fit.</source>
        <translation>%2 个频率中有 %1 个的相干性不低于 %3；其余淡显，不参与任何裕度和拟合。</translation>
    </message>
    <message>
        <source>%1 to %2 Hz: amplitude %3°</source>
        <translation>%1 至 %2 Hz：幅值 %3°</translation>
    </message>
    <message>
        <source>While excited the rotor never turned slower than %1 rad/s.</source>
        <translation>激励期间转子转速从未低于 %1 rad/s。</translation>
    </message>
    <message>
        <source>Current up to %1 A, coils up to %2 °C.</source>
        <translation>电流最大 %1 A，线圈最高 %2 °C。</translation>
    </message>
</context>
<context>
    <name>halbench::app::Freshness</name>
    <message>
        <source>No new values since %1</source>
        <translation>自 %1 起没有新值</translation>
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
    <message>
        <source>Gain K</source>
        <translation>增益 K</translation>
    </message>
    <message>
        <source>Integral time T_i</source>
        <translation>积分时间 T_i</translation>
    </message>
    <message>
        <source>Derivative time T_d</source>
        <translation>微分时间 T_d</translation>
    </message>
    <message>
        <source>Empty: no integral action</source>
        <translation>留空：无积分作用</translation>
    </message>
    <message>
        <source>Parallel form</source>
        <translation>并联形式</translation>
    </message>
    <message>
        <source>Standard form</source>
        <translation>标准形式</translation>
    </message>
    <message>
        <source>Series form</source>
        <translation>串联形式</translation>
    </message>
    <message>
        <source>Form of the gains</source>
        <translation>增益的形式</translation>
    </message>
    <message>
        <source>Parallel: K_P + K_I/s + K_D s. Standard: K (1 + 1/(T_i s) + T_d s). Series: K (1 + 1/(T_i s))(1 + T_d s). The board and files have the parallel form</source>
        <translation>并联：K_P + K_I/s + K_D s。标准：K (1 + 1/(T_i s) + T_d s)。串联：K (1 + 1/(T_i s))(1 + T_d s)。控制板和文件使用并联形式</translation>
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
    <message>
        <source>This page is in English only.</source>
        <translation>本页只有英文版。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Closes the help (Ctrl+W; Esc too while nothing is armed and no procedure runs)</source>
        <translation>关闭帮助（Ctrl+W；未使能且无流程运行时也可按 Esc）</translation>
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
        <source>F&amp;rom current</source>
        <translation>起始电流(&amp;R)</translation>
    </message>
    <message>
        <source>T&amp;o current</source>
        <translation>终止电流(&amp;O)</translation>
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
        <source>Given dampi&amp;ng c</source>
        <translation>已知阻尼 c(&amp;N)</translation>
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
        <source>Correct it or leave it empty</source>
        <translation>请更正或留空</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; cannot be used. %3 The field shows %4 A again.</source>
        <translation>%1：“%2”不可用。%3 输入框恢复显示 %4 A。</translation>
    </message>
    <message>
        <source>Correct the number</source>
        <translation>请更正该数值</translation>
    </message>
    <message>
        <source>It is smaller than &quot;%1&quot;.</source>
        <translation>它小于“%1”。</translation>
    </message>
    <message>
        <source>Make one larger or the other smaller</source>
        <translation>请增大前者或减小后者</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
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
        <translation>拟合</translation>
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
    <message>
        <source>Without a given inertia J or torque constant φ only their quotients come out; that is enough for tuning.</source>
        <translation>若未给定转动惯量 J 或转矩常数 φ，则只能得到它们的比值；这对整定已足够。</translation>
    </message>
    <message>
        <source>K_f/φ, friction as a current</source>
        <translation>K_f/φ，以电流表示的摩擦</translation>
    </message>
    <message>
        <source>K_f/φ is the current that friction takes while the rotor moves. Calibrate finds another figure: the current that starts it from rest, usually more.</source>
        <translation>K_f/φ 是转子转动时克服摩擦所需的电流。标定得到的是另一个量：使转子从静止起动的电流，通常更大。</translation>
    </message>
    <message>
        <source>What is the difference?</source>
        <translation>有何区别？</translation>
    </message>
    <message>
        <source>in virtual time, without a date</source>
        <translation>虚拟时间，无日期</translation>
    </message>
    <message>
        <source>%1 minutes of device time</source>
        <translation>设备时间 %1 分</translation>
    </message>
    <message>
        <source>coils up to %1 °C</source>
        <translation>线圈最高 %1 °C</translation>
    </message>
    <message>
        <source>No device is connected to compare it with.</source>
        <translation>没有连接可供比较的设备。</translation>
    </message>
    <message>
        <source>It is the device that is connected.</source>
        <translation>它就是当前连接的设备。</translation>
    </message>
    <message>
        <source>Connected is another one: %1.</source>
        <translation>当前连接的是另一个设备：%1。</translation>
    </message>
    <message>
        <source>Good, with the remarks below</source>
        <translation>良好，请留意下列说明</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportForm</name>
    <message>
        <source>as found: %1</source>
        <translation>识别结果：%1</translation>
    </message>
    <message>
        <source>not certain</source>
        <translation>不确定</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>分隔符</translation>
    </message>
    <message>
        <source>What stands between the columns</source>
        <translation>列之间的字符</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>逗号</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>分号</translation>
    </message>
    <message>
        <source>tabulator</source>
        <translation>制表符</translation>
    </message>
    <message>
        <source>blank</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>none, one column</source>
        <translation>无，只有一列</translation>
    </message>
    <message>
        <source>Decimal sign</source>
        <translation>小数点符号</translation>
    </message>
    <message>
        <source>What stands before the decimals of a number</source>
        <translation>数字小数部分之前的符号</translation>
    </message>
    <message>
        <source>point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Header</source>
        <translation>表头</translation>
    </message>
    <message>
        <source>What stands above the numbers</source>
        <translation>数字上方的内容</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>names</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>names, then units</source>
        <translation>名称，然后单位</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>The column of the time, or how many rows were sampled in a second</source>
        <translation>时间列，或每秒采样的行数</translation>
    </message>
    <message>
        <source>Rows a second</source>
        <translation>每秒行数</translation>
    </message>
    <message>
        <source>How many rows were sampled in a second</source>
        <translation>每秒采样的行数</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>列 %1</translation>
    </message>
    <message>
        <source>none: rows a second</source>
        <translation>无：按每秒行数</translation>
    </message>
    <message>
        <source>Say how many rows were sampled in a second.</source>
        <translation>请给出每秒采样的行数。</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportTable</name>
    <message>
        <source>You said this; emptied (Delete), it is as found in the table</source>
        <translation>这是您指定的；清空（Delete）后恢复为表中识别的内容</translation>
    </message>
    <message>
        <source>First rows as they would be read</source>
        <translation>将要读取的前几行</translation>
    </message>
    <message>
        <source>The first rows in the units of the recording; above each what its column becomes</source>
        <translation>以记录的单位显示前几行；上方说明每一列成为什么</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>列 %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Name of column %1</source>
        <translation>列 %1 的名称</translation>
    </message>
    <message>
        <source>The column of the time is chosen above</source>
        <translation>时间列在上方选择</translation>
    </message>
    <message>
        <source>What the recording calls this column: write a name, F2 changes it</source>
        <translation>记录中此列的名称：直接输入，按 F2 修改</translation>
    </message>
    <message>
        <source>Unit of column %1</source>
        <translation>列 %1 的单位</translation>
    </message>
    <message>
        <source>What its numbers are written in, for example rpm or mA; a hyphen: no unit</source>
        <translation>其数值所用的单位，例如 rpm 或 mA；连字符表示无单位</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportView</name>
    <message>
        <source>Choose table…</source>
        <translation>选择表…</translation>
    </message>
    <message>
        <source>A table that another program wrote; the window&apos;s key for it is Ctrl+I</source>
        <translation>由其他程序写出的表；窗口快捷键为 Ctrl+I</translation>
    </message>
    <message>
        <source>Table that is imported</source>
        <translation>要导入的表</translation>
    </message>
    <message>
        <source>Name of the recording</source>
        <translation>记录的名称</translation>
    </message>
    <message>
        <source>The recording gets this name, in the folder of the recordings</source>
        <translation>记录以此名称保存在记录文件夹中</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Reads all rows, writes the recording and shows it</source>
        <translation>读取所有行，写入记录并显示</translation>
    </message>
    <message>
        <source>What is missing for the import</source>
        <translation>导入还缺什么</translation>
    </message>
    <message>
        <source>Choose table</source>
        <translation>选择表</translation>
    </message>
    <message>
        <source>Table (*.csv *.txt *.tsv *.dat);;All files (*)</source>
        <translation>表 (*.csv *.txt *.tsv *.dat);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Choose a table first. What of it is not certain is asked here.</source>
        <translation>请先选择一个表。其中不确定的内容会在此询问。</translation>
    </message>
    <message>
        <source>The table is being read.</source>
        <translation>正在读取表。</translation>
    </message>
    <message>
        <source>The table cannot be read like this; above stands why.</source>
        <translation>无法这样读取该表；原因见上方。</translation>
    </message>
    <message>
        <source>To be answered above: %1.</source>
        <translation>请在上方回答：%1。</translation>
    </message>
    <message>
        <source>The recording needs a name, which is no folder.</source>
        <translation>记录需要一个名称，且不能是文件夹。</translation>
    </message>
    <message>
        <source>There is a recording of this name already.</source>
        <translation>已有同名的记录。</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>正在导入</translation>
    </message>
    <message>
        <source>Importing: %1 rows</source>
        <translation>正在导入：%1 行</translation>
    </message>
    <message>
        <source>Imported: %1 rows in %2</source>
        <translation>已导入：%1 行，保存在 %2</translation>
    </message>
</context>
<context>
    <name>halbench::app::ImportWords</name>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>unit not known</source>
        <translation>单位未知</translation>
    </message>
    <message>
        <source>no unit</source>
        <translation>无单位</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>列 %1</translation>
    </message>
    <message>
        <source>from %1</source>
        <translation>来自 %1</translation>
    </message>
    <message>
        <source>time [s]
by %1 rows a second</source>
        <translation>时间 [s]
每秒 %1 行</translation>
    </message>
    <message>
        <source>Choose separator, decimal sign, header or time above as they are in the table, or mend the table.</source>
        <translation>请在上方按表中的实际情况选择分隔符、小数点符号、表头或时间，或修改该表。</translation>
    </message>
    <message>
        <source>how columns and numbers are written</source>
        <translation>列和数字的写法</translation>
    </message>
    <message>
        <source>what the first lines are</source>
        <translation>前几行是什么</translation>
    </message>
    <message>
        <source>which column is the time</source>
        <translation>哪一列是时间</translation>
    </message>
    <message>
        <source>there is none: rows a second</source>
        <translation>没有：按每秒行数</translation>
    </message>
    <message>
        <source>its numbers are in %1</source>
        <translation>其数字的单位是 %1</translation>
    </message>
    <message>
        <source>separator %1</source>
        <translation>分隔符 %1</translation>
    </message>
    <message>
        <source>decimal comma</source>
        <translation>小数逗号</translation>
    </message>
    <message>
        <source>decimal point</source>
        <translation>小数点</translation>
    </message>
    <message>
        <source>%1; it reads %2</source>
        <translation>%1；读作 %2</translation>
    </message>
    <message>
        <source>Not certain: %1</source>
        <translation>不确定：%1</translation>
    </message>
    <message>
        <source>Only you know; nothing is imported before it is answered</source>
        <translation>只有您知道；回答之前不会导入</translation>
    </message>
    <message>
        <source>Please choose</source>
        <translation>请选择</translation>
    </message>
    <message>
        <source>First lines, as they are</source>
        <translation>原样的前几行</translation>
    </message>
    <message>
        <source>Write another name or unit for the column below, or choose another column as the time above.</source>
        <translation>请在下方为该列填写其他名称或单位，或在上方选择其他列作为时间。</translation>
    </message>
    <message>
        <source>Choose the column of the time above, or say there how many rows were sampled in a second; a table that is out of order is to be mended.</source>
        <translation>请在上方选择时间列，或在那里给出每秒采样的行数；顺序错误的表需先更正。</translation>
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
    <message>
        <source>link: lost, reconnecting</source>
        <translation>链路：已断开，正在重连</translation>
    </message>
</context>
<context>
    <name>halbench::app::LiveHall</name>
    <message>
        <source>Hall B</source>
        <translation>霍尔 B</translation>
    </message>
    <message>
        <source>Field that the Hall sensors read</source>
        <translation>霍尔传感器读到的磁场</translation>
    </message>
    <message>
        <source>Hall A</source>
        <translation>霍尔 A</translation>
    </message>
</context>
<context>
    <name>halbench::app::LivePicture</name>
    <message>
        <source>Connect the simulated motor</source>
        <translation>连接仿真电机</translation>
    </message>
    <message>
        <source>Save data…</source>
        <translation>保存数据…</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>保存数据</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>saved: %1</source>
        <translation>已保存：%1</translation>
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
    <name>halbench::app::LogPanel</name>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>released</source>
        <translation>已解除</translation>
    </message>
    <message>
        <source>actuator</source>
        <translation>执行器</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>已使能</translation>
    </message>
    <message>
        <source>disarmed</source>
        <translation>未使能</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>已结束</translation>
    </message>
    <message>
        <source>started</source>
        <translation>已开始</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>started: %1</source>
        <translation>已开始：%1</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>found changed: %1</source>
        <translation>发现已改变：%1</translation>
    </message>
    <message>
        <source>history</source>
        <translation>历史</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopCapture</name>
    <message>
        <source>capture</source>
        <translation>捕获</translation>
    </message>
    <message>
        <source>the device was gone before its capture settings could be put back: unless it was restarted, they are still those of the capture</source>
        <translation>设备在其捕获设置恢复之前已断开：除非它被重新启动，否则仍是捕获时的设置</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopFigures</name>
    <message>
        <source>modulus margin</source>
        <translation>模裕度</translation>
    </message>
    <message>
        <source>imaginary part of L</source>
        <translation>L 的虚部</translation>
    </message>
    <message>
        <source>unit circle</source>
        <translation>单位圆</translation>
    </message>
    <message>
        <source>Nyquist plot of the open loop</source>
        <translation>开环 Nyquist 图</translation>
    </message>
    <message>
        <source>real part of L</source>
        <translation>L 的实部</translation>
    </message>
    <message>
        <source>magnitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>Nichols plot of the open loop</source>
        <translation>开环 Nichols 图</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>相位</translation>
    </message>
    <message>
        <source>sensitivity S</source>
        <translation>灵敏度 S</translation>
    </message>
    <message>
        <source>closed loop T</source>
        <translation>闭环 T</translation>
    </message>
    <message>
        <source>Sensitivity and closed loop</source>
        <translation>灵敏度与闭环</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>measured, not coherent</source>
        <translation>实测，不相干</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopSliders</name>
    <message>
        <source>S&amp;peed</source>
        <translation>速度(&amp;P)</translation>
    </message>
    <message>
        <source>Speed: gain crossover</source>
        <translation>速度：增益穿越频率</translation>
    </message>
    <message>
        <source>Where the open loop has the gain 1: the motor follows up to there. The phase margin is kept as far as it can be. Arrow keys: 2 %, Page up and down: a quarter</source>
        <translation>开环增益为 1 之处：电机能跟随到此频率。相位裕度尽可能保持不变。方向键：2 %，翻页键：四分之一</translation>
    </message>
    <message>
        <source>&amp;Robustness</source>
        <translation>稳健性(&amp;R)</translation>
    </message>
    <message>
        <source>Robustness: phase margin</source>
        <translation>稳健性：相位裕度</translation>
    </message>
    <message>
        <source>Phase margin at that crossover, which stays. Arrow keys: 1°, Page up and down: 5°</source>
        <translation>该穿越频率处的相位裕度，频率保持不变。方向键：1°，翻页键：5°</translation>
    </message>
    <message>
        <source>Only %1: the range ends there.</source>
        <translation>只到 %1：范围到此为止。</translation>
    </message>
    <message>
        <source>Only %1: else K_D is negative.</source>
        <translation>只到 %1：否则 K_D 为负。</translation>
    </message>
    <message>
        <source>Only %1: else it only damps.</source>
        <translation>只到 %1：否则只有阻尼作用。</translation>
    </message>
    <message>
        <source>Only %1: gain margin %2.</source>
        <translation>只到 %1：增益裕度 %2。</translation>
    </message>
    <message>
        <source>Asked for: %1. The nearest that can be had is taken.</source>
        <translation>要求：%1。取可达到的最接近值。</translation>
    </message>
</context>
<context>
    <name>halbench::app::LoopView</name>
    <message>
        <source>Bode</source>
        <translation>Bode</translation>
    </message>
    <message>
        <source>Nyquist</source>
        <translation>Nyquist</translation>
    </message>
    <message>
        <source>Nichols</source>
        <translation>Nichols</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>灵敏度</translation>
    </message>
    <message>
        <source>View of the open loop</source>
        <translation>开环的视图</translation>
    </message>
    <message>
        <source>The closed loop is unstable: it has no sensitivity.</source>
        <translation>闭环不稳定：没有灵敏度。</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Root locus</source>
        <translation>根轨迹</translation>
    </message>
    <message>
        <source>Bode: magnitude and phase over frequency. Nyquist: the plane around -1. Nichols: magnitude over phase. Sensitivity: what is left of a disturbance, and what follows the reference. Root locus: the poles of the closed loop, and where they go with the gain</source>
        <translation>Bode：幅值和相位对频率。Nyquist：-1 周围的平面。Nichols：幅值对相位。灵敏度：扰动的残留，以及跟随参考值的部分。根轨迹：闭环极点，以及它们随增益的去向</translation>
    </message>
    <message>
        <source>gain crossover</source>
        <translation>增益穿越频率</translation>
    </message>
    <message>
        <source>phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>all gains, along the branch</source>
        <translation>所有增益，沿分支</translation>
    </message>
    <message>
        <source>Wrap the phase</source>
        <translation>折叠相位</translation>
    </message>
    <message>
        <source>Draw the phase of the Bode plot between -180 and 180 degrees instead of as one line</source>
        <translation>把 Bode 图的相位画在 -180 度与 180 度之间，而不是画成一条线</translation>
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
    <message>
        <source>&amp;Preferences…</source>
        <translation>首选项(&amp;P)…</translation>
    </message>
    <message>
        <source>%1 is open in another window.</source>
        <translation>%1 已在另一个窗口中打开。</translation>
    </message>
    <message>
        <source>Close it there, or open a copy as a new project; the file itself stays with the other window.</source>
        <translation>请在那里关闭它，或将副本作为新项目打开；文件本身仍归另一个窗口。</translation>
    </message>
    <message>
        <source>Open a copy</source>
        <translation>打开副本</translation>
    </message>
    <message>
        <source>The autosave of the project could not be read; it was kept as %1.</source>
        <translation>项目的自动保存文件无法读取；已保留为 %1。</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>项目另存为…</translation>
    </message>
    <message>
        <source>The window stays open, so that what was not saved is not lost.</source>
        <translation>窗口保持打开，以免未保存的内容丢失。</translation>
    </message>
    <message>
        <source>Save the project elsewhere, or close the window without it.</source>
        <translation>请将项目保存到别处，或不保存直接关闭窗口。</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>仍然关闭</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>入门(&amp;F)</translation>
    </message>
    <message>
        <source>The program ends as soon as what runs has ended and the actuator is disarmed.</source>
        <translation>运行中的任务结束且执行器解除使能后，程序随即退出。</translation>
    </message>
    <message>
        <source>STOP and Esc work until then.</source>
        <translation>在此之前 STOP 和 Esc 仍然有效。</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>by Esc</source>
        <translation>由 Esc</translation>
    </message>
    <message>
        <source>by STOP of a panel</source>
        <translation>由面板的“停止”</translation>
    </message>
    <message>
        <source>by STOP</source>
        <translation>由“停止”</translation>
    </message>
    <message>
        <source>by STOP of the help</source>
        <translation>由帮助窗口的“停止”</translation>
    </message>
    <message>
        <source>asked for %1</source>
        <translation>%1请求</translation>
    </message>
    <message>
        <source>project</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Take them up</source>
        <translation>采用它们</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>Import a &amp;table…</source>
        <translation>导入表(&amp;T)…</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) of %1 are beyond the limits of the preferences and stay for now.</source>
        <translation>
            <numerusform>%1 中有 %n 条记录超出首选项的限制，暂时保留。</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody has seen yet what goes from this folder. The preferences show it; nothing goes before.</source>
        <translation>尚无人看过此文件夹中将移除的内容。首选项会显示；在此之前不移除任何内容。</translation>
    </message>
    <message>
        <source>recordings</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>首选项…</translation>
    </message>
    <message>
        <source>What the project says of recordings holds from the next one on.</source>
        <translation>项目中关于记录的设置从下一条记录起生效。</translation>
    </message>
    <message>
        <source>The present one ends as it was begun; saving the project loses nothing of it.</source>
        <translation>当前记录按开始时的设置结束；保存项目不会丢失任何内容。</translation>
    </message>
    <message>
        <source>Plots are shown as usual where the project says what cannot be: %1</source>
        <translation>项目中不可能成立之处，曲线图照常显示：%1</translation>
    </message>
    <message>
        <source>The file keeps these lines until the project is saved.</source>
        <translation>文件在项目保存之前保留这些行。</translation>
    </message>
    <message>
        <source>%1 has unsaved work of an earlier session.</source>
        <translation>%1 有上次会话未保存的工作。</translation>
    </message>
    <message>
        <source>Opening the project takes it up again.</source>
        <translation>打开项目即可继续。</translation>
    </message>
    <message>
        <source>Open the project</source>
        <translation>打开项目</translation>
    </message>
</context>
<context>
    <name>halbench::app::ModeBox</name>
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
D-axis: current that holds the rotor without turning it (%1)</source>
        <translation>空闲：无电流。电流：手动给定转矩。位置：保持并跟随。
D 轴：保持转子而不使其转动的电流 (%1)</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorCapture</name>
    <message>
        <source>This board cannot capture by itself.</source>
        <translation>此控制板不能自行捕获。</translation>
    </message>
    <message>
        <source>%1 at %2 Hz, %3 s from %4 s before the event</source>
        <translation>%1，%2 Hz，共 %3 s，从事件前 %4 s 开始</translation>
    </message>
    <message>
        <source>Held back</source>
        <translation>暂缓</translation>
    </message>
    <message>
        <source>A procedure has the device; the board&apos;s capture goes on after it</source>
        <translation>过程正在使用设备；控制板的捕获在其后继续</translation>
    </message>
    <message>
        <source>Begins</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>The board is set up to capture %1</source>
        <translation>正在设置控制板以捕获 %1</translation>
    </message>
    <message>
        <source>Fills</source>
        <translation>填充中</translation>
    </message>
    <message>
        <source>The board captures what lies before the event: %1</source>
        <translation>控制板正在捕获事件之前的部分：%1</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>The board waits until %1; captures %2</source>
        <translation>控制板等待：%1；捕获 %2</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>已触发</translation>
    </message>
    <message>
        <source>The event came; the board captures what follows</source>
        <translation>事件已到来；控制板正在捕获其后的部分</translation>
    </message>
    <message>
        <source>Caught</source>
        <translation>已捕获</translation>
    </message>
    <message>
        <source>Caught; it is read when the recording is over, so that no row is lost</source>
        <translation>已捕获；记录结束后再读取，以免丢失任何一行</translation>
    </message>
    <message>
        <source>Reads, %1 %</source>
        <translation>读取中，%1 %</translation>
    </message>
    <message>
        <source>Reads the capture from the board, %1 %</source>
        <translation>正在从控制板读取捕获，%1 %</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Stopped after an event; Shift+T waits again; %1</source>
        <translation>在一个事件后停止；Shift+T 再次等待；%1</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorData</name>
    <message>
        <source>Copy data</source>
        <translation>复制数据</translation>
    </message>
    <message>
        <source>Copy the samples in view, or between the cursors, as a table</source>
        <translation>把可见范围内或两光标之间的样本复制为表格</translation>
    </message>
    <message>
        <source>Save data…</source>
        <translation>保存数据…</translation>
    </message>
    <message>
        <source>Save the samples in view, or between the cursors, as CSV, MDF4 or MAT</source>
        <translation>把可见范围内或两光标之间的样本保存为 CSV、MDF4 或 MAT</translation>
    </message>
    <message>
        <source>Copied: %1 rows</source>
        <translation>已复制：%1 行</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>保存数据</translation>
    </message>
    <message>
        <source>plots.csv</source>
        <translation>plots.csv</translation>
    </message>
    <message>
        <source>Recording (*.csv *.mf4 *.mat)</source>
        <translation>记录 (*.csv *.mf4 *.mat)</translation>
    </message>
    <message>
        <source>Saved: %1 rows in %2</source>
        <translation>已保存：%1 行，%2</translation>
    </message>
    <message>
        <source>; on another time axis and not in it: %1</source>
        <translation>；位于其他时间轴，未包含：%1</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorForecast</name>
    <message>
        <source>the load has been steady for %1 of the %2 s that are needed</source>
        <translation>负载已稳定 %1 s，需要 %2 s</translation>
    </message>
    <message>
        <source>the temperature has not changed by one step of its sensor</source>
        <translation>温度尚未变化其传感器的一个分辨率</translation>
    </message>
    <message>
        <source>the temperature does not go as it does at a steady load</source>
        <translation>温度的变化与恒定负载下不同</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1 reaches %2 in %3 (95 %: %4 to %5) at this load.</source>
        <translation>在此负载下%1在 %3 后达到 %2（95 %：%4 到 %5）。</translation>
    </message>
    <message>
        <source>%1 does not reach %2 at this load: it goes to %3 to %4 °C.</source>
        <translation>在此负载下%1不会达到 %2：将稳定在 %3 到 %4 °C。</translation>
    </message>
    <message>
        <source>%1 does not reach %2 at this load.</source>
        <translation>在此负载下%1不会达到 %2。</translation>
    </message>
    <message>
        <source>%1 does not reach %2 for %3 at this load; whether at all is not known yet.</source>
        <translation>在此负载下%1在 %3 内不会达到 %2；是否会达到尚不清楚。</translation>
    </message>
    <message>
        <source>%1 is at its limit of %2.</source>
        <translation>%1已达到限值 %2。</translation>
    </message>
    <message>
        <source>Time to %1 not known: %2.</source>
        <translation>到 %1 的时间未知：%2。</translation>
    </message>
    <message>
        <source>Time until the coils reach their limit</source>
        <translation>线圈达到限值的时间</translation>
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
        <source>Signals of the project that this device does not have: %1</source>
        <translation>项目中该设备没有的信号：%1</translation>
    </message>
    <message>
        <source>They are left out; the project keeps them until you change the plots.</source>
        <translation>这些信号已略去；在您更改图表之前，项目会保留它们。</translation>
    </message>
    <message>
        <source>Nothing to watch yet</source>
        <translation>还没有可观察的内容</translation>
    </message>
    <message>
        <source>Shows what a connected device measures, live. Choose a device at the left, or try the simulated motor.</source>
        <translation>实时显示已连接设备的测量值。请在左侧选择设备，或试用仿真电机。</translation>
    </message>
    <message>
        <source>Connect the simulated motor</source>
        <translation>连接仿真电机</translation>
    </message>
    <message>
        <source>Not shown: %1</source>
        <translation>未显示：%1</translation>
    </message>
    <message>
        <source>The device samples them at other moments than the rest, or at none that repeat. Plot signals of one event together.</source>
        <translation>设备对它们的采样时刻与其余信号不同，或没有周期性采样。请一起绘制同一事件的信号。</translation>
    </message>
    <message>
        <source>Not in the running recording: %1</source>
        <translation>不在正在进行的记录中：%1</translation>
    </message>
    <message>
        <source>They are added when the recording has ended; until then the stream stays as it is, so that the recording has no gap.</source>
        <translation>记录结束后会加入；在此之前数据流保持不变，使记录没有间断。</translation>
    </message>
    <message>
        <source>Plot fewer signals.</source>
        <translation>请减少所绘的信号。</translation>
    </message>
    <message>
        <source>The markers are not kept: %1</source>
        <translation>标记未被保存：%1</translation>
    </message>
    <message>
        <source>Signal to plot</source>
        <translation>要绘出的信号</translation>
    </message>
    <message>
        <source>Plots the signal that is chosen (Insert)</source>
        <translation>绘出所选的信号（Insert）</translation>
    </message>
    <message>
        <source>Units of the project that do not fit their signals: %1</source>
        <translation>项目中与其信号不符的单位：%1</translation>
    </message>
    <message>
        <source>They are shown as in the preferences; choose others in the legend (U). The project keeps them until you change the plots.</source>
        <translation>它们按首选项显示；请在图例中另选单位（U）。项目会保留它们，直到您改变曲线图。</translation>
    </message>
    <message>
        <source>What is shown may not be what was recorded.</source>
        <translation>显示的内容可能不是当时录制的内容。</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorPicture</name>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Copy the plots as a picture</source>
        <translation>把图复制为图片</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Save the plots as SVG, PDF or PNG</source>
        <translation>把图保存为 SVG、PDF 或 PNG</translation>
    </message>
    <message>
        <source>Plots of %1</source>
        <translation>%1 的曲线图</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>plots.svg</source>
        <translation>plots.svg</translation>
    </message>
    <message>
        <source>Picture (*.svg *.pdf *.png)</source>
        <translation>图片 (*.svg *.pdf *.png)</translation>
    </message>
    <message>
        <source>%1, reference</source>
        <translation>%1，参考</translation>
    </message>
    <message>
        <source>Pictures in the window&apos;s colours</source>
        <translation>图片采用窗口的颜色</translation>
    </message>
    <message>
        <source>Otherwise they are light, for paper and documents</source>
        <translation>否则为浅色，适合纸张和文档</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorRate</name>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Live rate</source>
        <translation>实时速率</translation>
    </message>
    <message>
        <source>More rows per second for the plots, as many as the device and its link carry</source>
        <translation>曲线图每秒得到更多的行，以设备及其链路所能承载为限</translation>
    </message>
    <message>
        <source>What is plotted cannot come at %1; it comes at %2, the most that the device and its link carry.</source>
        <translation>所绘信号无法以 %1 到来；现以 %2 到来，这是设备及其链路所能承载的最大值。</translation>
    </message>
    <message>
        <source>As usual, %1</source>
        <translation>照常，%1</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>照常</translation>
    </message>
    <message>
        <source>The device and its link carry no more</source>
        <translation>设备及其链路不能承载更多</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorRecording</name>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>Showing %1</source>
        <translation>正在显示 %1</translation>
    </message>
    <message>
        <source>Cancelled: the plots show the first %1 s of %2 s.</source>
        <translation>已取消：曲线图显示 %2 s 中的前 %1 s。</translation>
    </message>
    <message>
        <source>recording of %1 s</source>
        <translation>%1 s 的记录</translation>
    </message>
    <message>
        <source>no signals</source>
        <translation>无信号</translation>
    </message>
    <message>
        <source>time passes only while a procedure runs</source>
        <translation>仅在任务运行时时间才流逝</translation>
    </message>
    <message numerus="yes">
        <source>%n signal(s), %1 Hz, rows lost: %2</source>
        <translation>
            <numerusform>%n 个信号，%1 Hz，丢失 %2 行</numerusform>
        </translation>
    </message>
    <message>
        <source>The markers are not kept: %1</source>
        <translation>标记未被保存：%1</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorReference</name>
    <message>
        <source>Reference from a recording…</source>
        <translation>用记录作参考…</translation>
    </message>
    <message>
        <source>Lay a recording under the curves, aligned at the trigger or at the beginning</source>
        <translation>把一条记录放在曲线下方，按触发或开头对齐</translation>
    </message>
    <message>
        <source>Reference from a recording</source>
        <translation>用记录作参考</translation>
    </message>
    <message>
        <source>Recording (*.csv *.mf4)</source>
        <translation>记录 (*.csv *.mf4)</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考</translation>
    </message>
    <message>
        <source>Faint curves below the live ones: keep what is shown (K), a recording (Ctrl+K), none (Shift+K)</source>
        <translation>实时曲线下方的浅色曲线：保留所显示的（K）、一个记录（Ctrl+K）、去掉（Shift+K）</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorStatistics</name>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
    <message>
        <source>Smallest, largest, mean, rms and spread of what is in view or between the cursors (S)</source>
        <translation>视图内或两光标之间的最小、最大、均值、有效值和离散度 (S)</translation>
    </message>
    <message>
        <source>In view, %1 s</source>
        <translation>视图内，%1 s</translation>
    </message>
    <message>
        <source>In view of each plot</source>
        <translation>各曲线图视图内</translation>
    </message>
    <message>
        <source>Reading the disk</source>
        <translation>正在读取磁盘</translation>
    </message>
    <message>
        <source>A to B, %1 s</source>
        <translation>A 到 B，%1 s</translation>
    </message>
</context>
<context>
    <name>halbench::app::MonitorTrigger</name>
    <message>
        <source>Trigger</source>
        <translation>触发</translation>
    </message>
    <message>
        <source>Oscilloscope: show the time around the newest event until the next one</source>
        <translation>示波器：显示最新事件前后的时间，直到下一事件</translation>
    </message>
    <message>
        <source>Wait again</source>
        <translation>再次等待</translation>
    </message>
    <message>
        <source>Forget what was seen and wait for the next event</source>
        <translation>忘记已见内容并等待下一事件</translation>
    </message>
    <message>
        <source>No samples of %1 come</source>
        <translation>没有收到 %1 的采样</translation>
    </message>
    <message>
        <source>Waiting until %1</source>
        <translation>等待：%1</translation>
    </message>
    <message>
        <source>Triggered; the window is not over yet</source>
        <translation>已触发；窗口尚未结束</translation>
    </message>
    <message>
        <source>Auto: no event, shown by itself; waiting until %1</source>
        <translation>自动：没有事件，自行显示；等待：%1</translation>
    </message>
    <message>
        <source>Triggered at %1 s; waiting for the next</source>
        <translation>在 %1 s 触发；等待下一次</translation>
    </message>
    <message>
        <source>Stopped after the event at %1 s; Shift+T waits again</source>
        <translation>在 %1 s 的事件后停止；Shift+T 再次等待</translation>
    </message>
    <message>
        <source>No samples</source>
        <translation>没有样本</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Triggered</source>
        <translation>已触发</translation>
    </message>
    <message>
        <source>Auto: no event</source>
        <translation>自动：没有事件</translation>
    </message>
    <message>
        <source>Triggered at %1 s</source>
        <translation>在 %1 s 触发</translation>
    </message>
    <message>
        <source>Stopped at %1 s</source>
        <translation>在 %1 s 停止</translation>
    </message>
</context>
<context>
    <name>halbench::app::NoteLabel</name>
    <message>
        <source>Opens the help (Tab, Return)</source>
        <translation>打开帮助（Tab，回车）</translation>
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
    <name>halbench::app::NumberCheck</name>
    <message>
        <source>%1: &apos;%2&apos; cannot be used, nothing moves.</source>
        <translation>%1：“%2”无法使用，不会产生任何运动。</translation>
    </message>
    <message>
        <source>The field shows %1 again.</source>
        <translation>该栏重新显示 %1。</translation>
    </message>
</context>
<context>
    <name>halbench::app::PaceRow</name>
    <message>
        <source>Simulated &amp;time</source>
        <translation>仿真时间(&amp;T)</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>仿真时间</translation>
    </message>
    <message>
        <source>Speed of simulated time</source>
        <translation>仿真时间的快慢</translation>
    </message>
    <message>
        <source>How fast the simulated motor lives, or a recording is played: at 20 times a run of two minutes takes six seconds, 100 times slower a step of 50 ms takes five.
In the Monitor &lt; and &gt; change it. A real device has its own time.</source>
        <translation>仿真电机运行或播放记录的快慢：20 倍时两分钟的运行需要六秒，慢 100 倍时 50 ms 的阶跃需要五秒。
在监视中用 &lt; 和 &gt; 更改。真实设备有自己的时间。</translation>
    </message>
</context>
<context>
    <name>halbench::app::PaceSteps</name>
    <message>
        <source>as fast as possible</source>
        <translation>尽可能快</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>%1 times slower</source>
        <translation>慢 %1 倍</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 倍</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>变慢</translation>
    </message>
    <message>
        <source>Simulated or replayed time runs slower</source>
        <translation>仿真或播放的时间变慢</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>变快</translation>
    </message>
    <message>
        <source>Simulated or replayed time runs faster</source>
        <translation>仿真或播放的时间变快</translation>
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
        <source>Parameters that can only be read: %1.</source>
        <translation>只能读取的参数：%1。</translation>
    </message>
    <message>
        <source>The device takes no writes to them or to the page that it runs on.</source>
        <translation>设备不接受对它们或其所运行页的写入。</translation>
    </message>
    <message>
        <source>This device cannot switch a whole set: values that do not lie side by side changed one by one.</source>
        <translation>此设备不能整组切换：不相邻的值是逐个改变的。</translation>
    </message>
    <message>
        <source>Saves the edited column as a preset of this name (Enter)</source>
        <translation>将编辑列保存为此名称的预设（回车键）</translation>
    </message>
    <message>
        <source>Save preset</source>
        <translation>保存预设</translation>
    </message>
    <message>
        <source>Saves the edited column as a preset of this name (Enter in the name)</source>
        <translation>将编辑列保存为此名称的预设（在名称中按回车键）</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Save the values as a preset, or serve the device to have one that lasts.</source>
        <translation>请将这些值保存为预设，或用 serve 提供设备以便持久保存。</translation>
    </message>
    <message>
        <source>Preset saved as %1.</source>
        <translation>预设已保存为 %1。</translation>
    </message>
</context>
<context>
    <name>halbench::app::PerspectiveBar</name>
    <message>
        <source>Arrange the panels for %1 (%2)</source>
        <translation>按“%1”布置面板 (%2)</translation>
    </message>
    <message>
        <source>Perspective %1</source>
        <translation>视角 %1</translation>
    </message>
    <message>
        <source>Arrange the panels for another task (Ctrl+1 to Ctrl+5)</source>
        <translation>为其他任务排列面板 (Ctrl+1 至 Ctrl+5)</translation>
    </message>
</context>
<context>
    <name>halbench::app::PlotRows</name>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
</context>
<context>
    <name>halbench::app::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主题(&amp;T)</translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation>窗口的颜色</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>Language of the window; files stay as they are</source>
        <translation>窗口的语言；文件保持不变</translation>
    </message>
    <message>
        <source>&amp;Angles in</source>
        <translation>角度单位(&amp;A)</translation>
    </message>
    <message>
        <source>Unit of measured angles; files are always in SI units</source>
        <translation>测得角度的单位；文件始终使用国际单位制</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>度</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>弧度</translation>
    </message>
    <message>
        <source>&amp;Speeds in</source>
        <translation>转速单位(&amp;S)</translation>
    </message>
    <message>
        <source>Unit of measured speeds; files are always in SI units</source>
        <translation>测得转速的单位；文件始终使用国际单位制</translation>
    </message>
    <message>
        <source>revolutions per minute</source>
        <translation>转每分</translation>
    </message>
    <message>
        <source>degrees per second</source>
        <translation>度每秒</translation>
    </message>
    <message>
        <source>radians per second</source>
        <translation>弧度每秒</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Lock-out after a stop</source>
        <translation>停止后的锁定时间</translation>
    </message>
    <message>
        <source>After a stop, so long re-arming is refused</source>
        <translation>停止后在此时间内拒绝解除锁定</translation>
    </message>
    <message>
        <source>Lock-&amp;out after a stop</source>
        <translation>停止后的锁定时间(&amp;O)</translation>
    </message>
    <message>
        <source>Use what is chosen (Enter)</source>
        <translation>使用所选设置 (Enter)</translation>
    </message>
    <message>
        <source>Leave all as it was (Esc, which stops too)</source>
        <translation>保持原样（Esc，同时会停止）</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source>History on the disk, at most</source>
        <translation>磁盘上的历史，最多</translation>
    </message>
    <message>
        <source>So much of the disk this window takes for samples that memory has no room for; beyond it the oldest go first. 4 GB of the disk stay free in any case. A smaller limit is reached as samples come; recordings are not concerned</source>
        <translation>本窗口为内存放不下的样本最多占用这么多磁盘空间；超出后最旧的样本最先被移除。无论如何磁盘保留 4 GB 空闲。较小的限值随新样本的到来而达到；记录不受影响</translation>
    </message>
    <message>
        <source>used: %1 GB</source>
        <translation>已用：%1 GB</translation>
    </message>
    <message>
        <source>History on the disk now</source>
        <translation>当前磁盘上的历史</translation>
    </message>
    <message>
        <source>&amp;History on the disk</source>
        <translation>磁盘上的历史(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Frequencies in</source>
        <translation>频率单位(&amp;F)</translation>
    </message>
    <message>
        <source>Unit of the frequency axes of loops and responses; files have Hz</source>
        <translation>回路和响应的频率轴单位；文件使用 Hz</translation>
    </message>
    <message>
        <source>hertz</source>
        <translation>赫兹</translation>
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
    <message>
        <source>%1, up to %2 expected during the run</source>
        <translation>%1，运行中预计最高 %2</translation>
    </message>
    <message>
        <source>The connection is lost; the device is being looked for</source>
        <translation>连接已丢失；正在寻找设备</translation>
    </message>
    <message>
        <source>Plug it in again or switch it on</source>
        <translation>请重新插上或接通电源</translation>
    </message>
    <message>
        <source>Nothing is known of the motor behind this device: it has no profile here</source>
        <translation>不了解此设备所连的电机：此处没有它的配置</translation>
    </message>
    <message>
        <source>Watch, record and set it by name in Signals, Record and Parameters</source>
        <translation>可在“信号”、“记录”和“参数”中按名称观察、记录和设置</translation>
    </message>
    <message>
        <source>Press Release, beside the state at the top</source>
        <translation>请按上方状态旁边的“解除”</translation>
    </message>
    <message>
        <source>No fault, not stopped</source>
        <translation>无故障，未停止</translation>
    </message>
    <message>
        <source>The stop was released a moment ago</source>
        <translation>停止刚刚解除</translation>
    </message>
    <message>
        <source>Look, then start</source>
        <translation>请先查看，再启动</translation>
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
    <message>
        <source>%1 is open here, with changes that are not saved yet.</source>
        <translation>%1 已在此打开，且有尚未保存的更改。</translation>
    </message>
    <message>
        <source>The autosave of the project could not be read; it was kept as %1.</source>
        <translation>项目的自动保存文件无法读取；已保留为 %1。</translation>
    </message>
    <message>
        <source>The project itself is as it was saved.</source>
        <translation>项目本身与保存时一致。</translation>
    </message>
    <message>
        <source>This is a copy of %1, a new project without a name.</source>
        <translation>这是 %1 的副本，一个尚未命名的新项目。</translation>
    </message>
    <message>
        <source>Save it under a name of its own to keep it.</source>
        <translation>请以自己的名称保存它，以便保留。</translation>
    </message>
    <message>
        <source>%1 is open in another window.</source>
        <translation>%1 已在另一个窗口中打开。</translation>
    </message>
    <message>
        <source>Choose another name, or close the other window.</source>
        <translation>请选择其他名称，或关闭另一个窗口。</translation>
    </message>
    <message>
        <source>Unnamed project, %1</source>
        <translation>未命名项目，%1</translation>
    </message>
    <message>
        <source>No project is opened while the actuator is armed or a procedure runs: a slow disk would hold up Esc.</source>
        <translation>执行器已使能或任务运行时不打开项目：慢速磁盘会延误 Esc。</translation>
    </message>
    <message>
        <source>Disarm it, or wait for the end of the procedure, then open the project.</source>
        <translation>请先解除使能，或等待任务结束，再打开项目。</translation>
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
    <message>
        <source>calibration</source>
        <translation>标定</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordButton</name>
    <message>
        <source>recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Record data</source>
        <translation>记录数据</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>正在记录 %1</translation>
    </message>
    <message>
        <source>Recording to a file; a click ends it (Ctrl+R)</source>
        <translation>正在记录到文件；单击结束 (Ctrl+R)</translation>
    </message>
    <message>
        <source>Record data: write what is measured to a file (Ctrl+R)</source>
        <translation>记录数据：把测量值写入文件 (Ctrl+R)</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>The disk does not keep up: rows are missing.</source>
        <translation>磁盘跟不上：有行缺失。</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>Waiting for the event to record</source>
        <translation>等待事件以开始记录</translation>
    </message>
    <message>
        <source>Waiting for the trigger&apos;s event; a click ends the wait (Ctrl+R)</source>
        <translation>等待触发事件；单击结束等待（Ctrl+R）</translation>
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
        <source>Rows per second</source>
        <translation>每秒行数</translation>
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
        <source>Completes the file (Ctrl+R)</source>
        <translation>完成文件 (Ctrl+R)</translation>
    </message>
    <message>
        <source>Writes what is measured to a file (Ctrl+R)</source>
        <translation>把测量数据写入文件 (Ctrl+R)</translation>
    </message>
    <message>
        <source>What was measured, with its units; the sidecar beside it has the rest.</source>
        <translation>测量数据及其单位；旁边的附属文件包含其余信息。</translation>
    </message>
    <message>
        <source>Start recording</source>
        <translation>开始记录</translation>
    </message>
    <message>
        <source>%1 (gaps: %2, %3 s)</source>
        <translation>%1（间断：%2 处，%3 s）</translation>
    </message>
    <message>
        <source>Missing: %1; the sidecar says where.</source>
        <translation>缺失：%1；位置见附属文件。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln row(s) in %1</source>
        <translation>
            <numerusform>%1 中有 %Ln 行</numerusform>
        </translation>
    </message>
    <message>
        <source>The disk did not keep up with %1 of them.</source>
        <translation>其中 %1 行是磁盘跟不上造成的。</translation>
    </message>
    <message>
        <source>The disk does not keep up: rows are missing.</source>
        <translation>磁盘跟不上：有行缺失。</translation>
    </message>
    <message>
        <source>Record to another disk or fewer rows per second.</source>
        <translation>请记录到另一块磁盘，或减少每秒行数。</translation>
    </message>
    <message>
        <source>Time kept before the start</source>
        <translation>开始前保留的时间</translation>
    </message>
    <message>
        <source>So much from before the start is kept in memory and goes in front; 0: nothing</source>
        <translation>开始之前这么长的数据保留在内存中并放在前面；0：不保留</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>at the trigger</source>
        <translation>触发时</translation>
    </message>
    <message>
        <source>Start of the recording</source>
        <translation>记录的开始</translation>
    </message>
    <message>
        <source>At the trigger: Ctrl+R waits for the event that the Monitor&apos;s trigger is set to (T in the plots shows it)</source>
        <translation>触发时：按 Ctrl+R 等待监视器触发所设的事件（在曲线图中按 T 显示）</translation>
    </message>
    <message>
        <source>Time after the trigger</source>
        <translation>触发后的时间</translation>
    </message>
    <message>
        <source>The recording ends by itself so long after the event; 0: by hand</source>
        <translation>事件之后经过这么长时间记录自动结束；0：手动结束</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>After</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>What the recording waits for</source>
        <translation>记录所等待的事件</translation>
    </message>
    <message>
        <source>No samples of what the trigger waits for come.</source>
        <translation>触发所等待的信号没有样本到来。</translation>
    </message>
    <message>
        <source>Waiting until %1.</source>
        <translation>等待：%1。</translation>
    </message>
    <message>
        <source>Begins when %1.</source>
        <translation>开始条件：%1。</translation>
    </message>
    <message>
        <source>In memory: %1 of %2 s.</source>
        <translation>内存中：%1 / %2 s。</translation>
    </message>
    <message>
        <source>End the wait</source>
        <translation>结束等待</translation>
    </message>
    <message>
        <source>Wait for the trigger</source>
        <translation>等待触发</translation>
    </message>
    <message>
        <source>Nothing is recorded (Ctrl+R)</source>
        <translation>不作记录（Ctrl+R）</translation>
    </message>
    <message>
        <source>Records from the trigger&apos;s next event on (Ctrl+R)</source>
        <translation>从下一个触发事件起记录（Ctrl+R）</translation>
    </message>
    <message>
        <source>What {name} is in the name mask %1 (File &gt; Preferences)</source>
        <translation>名称模板 %1 中的 {name}（文件 &gt; 首选项）</translation>
    </message>
    <message>
        <source>Without ending; empty: by the name mask %1 (File &gt; Preferences)</source>
        <translation>不含扩展名；留空：按名称模板 %1（文件 &gt; 首选项）</translation>
    </message>
    <message>
        <source>At most as many as the device and its link carry</source>
        <translation>至多为设备及其链路所能承载的数目</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordedMarkers</name>
    <message>
        <source>marker</source>
        <translation>标记</translation>
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
    <message>
        <source>What is plotted cannot be recorded at %1 Hz.</source>
        <translation>所绘信号无法以 %1 Hz 记录。</translation>
    </message>
    <message>
        <source>The device and its link carry at most %1 Hz of it. Choose a lower rate, or plot fewer signals.</source>
        <translation>设备及其链路对此至多承载 %1 Hz。请选择较低的速率，或减少所绘的信号。</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingFields</name>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>还有 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>Names of recordings</source>
        <translation>记录的名称</translation>
    </message>
    <message>
        <source>Of recordings without a name of their own: {device}, {date} and {time} (UTC), {number}; {name} is what the Record panel has. The rest stays as it is</source>
        <translation>用于没有自己名称的记录：{device}、{date} 和 {time}（UTC）、{number}；{name} 取自“记录”面板。其余部分保持不变</translation>
    </message>
    <message>
        <source>Example of a recording&apos;s name</source>
        <translation>记录名称的示例</translation>
    </message>
    <message>
        <source>&amp;Names of recordings</source>
        <translation>记录的名称(&amp;N)</translation>
    </message>
    <message>
        <source>Only what the program named itself goes, the oldest first, into the trash; what the trash does not take stays. What has tags, notes or results, is open or less than a day old stays</source>
        <translation>只移除程序自己命名的记录，最旧的最先，移到回收站；回收站不接收的记录保留。有标签、备注或结果的、打开的或不到一天的记录保留</translation>
    </message>
    <message>
        <source>at &amp;most</source>
        <translation>最多(&amp;M)</translation>
    </message>
    <message>
        <source> days</source>
        <translation> 天</translation>
    </message>
    <message>
        <source>an&amp;d at most</source>
        <translation>且最多(&amp;D)</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source>Keep recordings for a time</source>
        <translation>按时间保留记录</translation>
    </message>
    <message>
        <source>Days that recordings are kept</source>
        <translation>保留记录的天数</translation>
    </message>
    <message>
        <source>Limit the disk of recordings</source>
        <translation>限制记录占用的磁盘</translation>
    </message>
    <message>
        <source>Disk that recordings take</source>
        <translation>记录占用的磁盘</translation>
    </message>
    <message>
        <source>Recordings that would go now</source>
        <translation>现在会移除的记录</translation>
    </message>
    <message>
        <source>Keep recordings</source>
        <translation>保留记录</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>e.g. %1.csv</source>
        <translation>例如 %1.csv</translation>
    </message>
    <message>
        <source>Nothing is ever removed.</source>
        <translation>从不移除任何记录。</translation>
    </message>
    <message>
        <source>Looking at what would go …</source>
        <translation>正在查看会移除什么…</translation>
    </message>
    <message>
        <source>With OK nothing goes now from %1.</source>
        <translation>按“确定”后现在不会从 %1 移除任何记录。</translation>
    </message>
    <message numerus="yes">
        <source>With OK %n recording(s) go to the trash now (%1), from %2.</source>
        <translation>
            <numerusform>按“确定”后现在有 %n 条记录移到回收站（%1），来自 %2。</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing goes from %1 for now: %2 is dated after now, so the clock is or was wrong.</source>
        <translation>暂不从 %1 移除任何内容：%2 的日期晚于现在，说明时钟现在或当时不准。</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingPlace</name>
    <message>
        <source>recordings</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>The folder of the last recording, %1, is not there; recordings go to %2.</source>
        <translation>上次记录的文件夹 %1 不存在；记录将保存到 %2。</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingTidying</name>
    <message>
        <source>recordings</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>not tidied away: %1</source>
        <translation>未清理：%1</translation>
    </message>
    <message>
        <source>older than the preferences keep</source>
        <translation>超过首选项的保留时间</translation>
    </message>
    <message>
        <source>no room by the preferences</source>
        <translation>超过首选项允许的空间</translation>
    </message>
    <message>
        <source>moved to the trash: %1 (%2)</source>
        <translation>已移到回收站：%1（%2）</translation>
    </message>
    <message>
        <source>nothing is tidied away: %1 is dated after now, so the clock is or was wrong</source>
        <translation>不清理任何内容：%1 的日期晚于现在，说明时钟现在或当时不准</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingTrigger</name>
    <message>
        <source>the set-point changes</source>
        <translation>设定值改变</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingsPanel</name>
    <message>
        <source>Search recordings</source>
        <translation>搜索记录</translation>
    </message>
    <message>
        <source>Search name, device, date, signals, tags, notes</source>
        <translation>搜索名称、设备、日期、信号、标签、备注</translation>
    </message>
    <message>
        <source>Every word must occur somewhere (Ctrl+F)</source>
        <translation>每个词都必须出现（Ctrl+F）</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>刷新</translation>
    </message>
    <message>
        <source>Looks into the folder again (F5)</source>
        <translation>重新查看文件夹（F5）</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>记录列表</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Begin at</source>
        <translation>起始于</translation>
    </message>
    <message>
        <source>Time of the recording at which it is played; Enter goes there</source>
        <translation>从记录的这一时间开始回放；回车跳转</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Makes a recording of what an interrupted program left</source>
        <translation>把中断的程序留下的内容恢复成记录</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>叠加</translation>
    </message>
    <message>
        <source>Results over time</source>
        <translation>结果随时间变化</translation>
    </message>
    <message>
        <source>Tags and notes</source>
        <translation>标签和备注</translation>
    </message>
    <message>
        <source>Tags of the recording</source>
        <translation>记录的标签</translation>
    </message>
    <message>
        <source>Tags, with commas between them</source>
        <translation>标签，用逗号分隔</translation>
    </message>
    <message>
        <source>Words to find it again; kept in its sidecar</source>
        <translation>便于查找的词；保存在附属文件中</translation>
    </message>
    <message>
        <source>Notes on the recording</source>
        <translation>记录的备注</translation>
    </message>
    <message>
        <source>Notes on this recording</source>
        <translation>此记录的备注</translation>
    </message>
    <message>
        <source>Kept in its sidecar</source>
        <translation>保存在附属文件中</translation>
    </message>
    <message>
        <source>No recordings in %1 yet. Record data (Ctrl+R) makes one.</source>
        <translation>%1 中还没有记录。“记录数据”（Ctrl+R）可创建记录。</translation>
    </message>
    <message>
        <source>An interrupted recording was recovered: %1 s in %2</source>
        <translation>已恢复一条中断的记录：%1 s，位于 %2</translation>
    </message>
    <message>
        <source>Nothing that was written is lost.</source>
        <translation>已写入的内容没有丢失。</translation>
    </message>
    <message>
        <source>Lost: %1 octets at its end or damaged.</source>
        <translation>丢失：末尾或损坏的 %1 个字节。</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>The damaged file is kept as %1.</source>
        <translation>损坏的文件保留为 %1。</translation>
    </message>
    <message>
        <source>Enter opens the selected recording; several are laid over each other</source>
        <translation>回车打开所选记录；选择多个则叠加显示</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Shows all of the recording in the panels at once (Enter). The device that is connected is left; not while it is armed, is recorded or works</source>
        <translation>在各面板中一次显示整条记录（回车）。当前连接的设备会断开；设备已使能、正在记录或正在工作时不可用</translation>
    </message>
    <message>
        <source>Plays the recording in the panels, as if its device were connected (Ctrl+Return). The device that is connected is left; not while it is armed, is recorded or works</source>
        <translation>在各面板中回放该记录，如同其设备已连接（Ctrl+回车）。当前连接的设备会断开；设备已使能、正在记录或正在工作时不可用</translation>
    </message>
    <message>
        <source>Overlay, results, tags and notes, import</source>
        <translation>叠加、结果、标签和备注、导入</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>This table is of another program: look below how it is read.</source>
        <translation>该表来自其他程序：请在下方查看读取方式。</translation>
    </message>
    <message>
        <source>Import makes a recording of it; the table stays as it is.</source>
        <translation>导入会由它生成记录；原表保持不变。</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>假如</translation>
    </message>
    <message>
        <source>Shows in Tune what the gains proposed there would have made of this move</source>
        <translation>在整定中显示那里建议的增益会使这次运动成为怎样</translation>
    </message>
</context>
<context>
    <name>halbench::app::RecordingsTableModel</name>
    <message>
        <source>interrupted</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>%1 (%2 rows)</source>
        <translation>%1（%2 行）</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1（仿真）</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>间断</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>结果</translation>
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
    <name>halbench::app::RelayForm</name>
    <message>
        <source>&amp;Base speed</source>
        <translation>基础转速(&amp;B)</translation>
    </message>
    <message>
        <source>Height of the relay</source>
        <translation>继电幅值</translation>
    </message>
    <message>
        <source>Swings</source>
        <translation>摆动次数</translation>
    </message>
    <message>
        <source>Steady speed that the loop swings around, at least 3 rad/s in either direction: friction is then a plain offset. Empty: as slow as is safe</source>
        <translation>回路围绕其摆动的匀速转速，任一方向至少 3 rad/s：这样摩擦只是一个偏置。留空：在安全范围内尽量慢</translation>
    </message>
    <message>
        <source>Current at which the controller saturates. Empty: as high as is safe</source>
        <translation>控制器饱和时的电流。留空：在安全范围内尽量大</translation>
    </message>
    <message>
        <source>That are measured, 40 to 400; the intervals shrink with their root. Empty: 100</source>
        <translation>所测的次数，40 至 400；区间随其平方根缩小。留空：100</translation>
    </message>
    <message>
        <source>what is safe</source>
        <translation>安全值</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Correct it or leave it empty</source>
        <translation>请更正，或留空</translation>
    </message>
</context>
<context>
    <name>halbench::app::RelayPanel</name>
    <message>
        <source>Save result</source>
        <translation>保存结果</translation>
    </message>
    <message>
        <source>Relay experiment (*.json)</source>
        <translation>继电实验 (*.json)</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>摆动</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Lets the loop swing by itself around a steady motion, with proportional control that saturates, and finds the gain at which it would swing for ever, with its 95 % interval. Calibrate the sensors first.</source>
        <translation>让回路在会饱和的比例控制下围绕匀速运动自行摆动，求出会永远振荡的增益及其 95 % 区间。请先标定传感器。</translation>
    </message>
    <message>
        <source>The rotor turns steadily and swings around that. STOP (Esc) and Cancel end it; gains, limits, mode, windows and generator are restored.</source>
        <translation>转子匀速转动，并围绕该运动摆动。“停止”（Esc）和“取消”结束实验；增益、限值、模式、窗口和信号发生器会恢复。</translation>
    </message>
    <message>
        <source>Start experiment</source>
        <translation>开始实验</translation>
    </message>
    <message>
        <source>The rotor turns and swings (Ctrl+Return); Esc stops it</source>
        <translation>转子转动并摆动（Ctrl+Return）；Esc 停止</translation>
    </message>
    <message>
        <source>Use in Tune</source>
        <translation>用于整定</translation>
    </message>
    <message>
        <source>Propose gains by Ziegler and Nichols from it, with their proof; nothing is applied</source>
        <translation>由此按齐格勒—尼科尔斯方法提出增益及其论证；不会应用任何内容</translation>
    </message>
    <message>
        <source>Save result…</source>
        <translation>保存结果…</translation>
    </message>
    <message>
        <source>Write the file that tune --relay reads</source>
        <translation>写出 tune --relay 读取的文件</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>重新测量</translation>
    </message>
    <message>
        <source>Back to the settings; this result stays until the next one</source>
        <translation>返回设置；此结果保留到下一个结果</translation>
    </message>
    <message>
        <source>The swing as recorded</source>
        <translation>记录的摆动</translation>
    </message>
    <message>
        <source>Ultimate gain and period</source>
        <translation>临界增益和临界周期</translation>
    </message>
    <message>
        <source>Relay experiment</source>
        <translation>继电实验</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>正在测量</translation>
    </message>
    <message>
        <source>Computing the result</source>
        <translation>正在计算结果</translation>
    </message>
    <message>
        <source>The experiment was cancelled; everything is as it was before.</source>
        <translation>实验已取消；一切与之前相同。</translation>
    </message>
</context>
<context>
    <name>halbench::app::RelayWords</name>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>被拒绝</translation>
    </message>
    <message>
        <source>The findings above say why, and what helps</source>
        <translation>上面的诊断说明原因和解决办法</translation>
    </message>
    <message>
        <source>ultimate gain of the model</source>
        <translation>模型的临界增益</translation>
    </message>
    <message>
        <source>identified motor</source>
        <translation>已辨识的电机</translation>
    </message>
    <message>
        <source>published motor</source>
        <translation>公开的电机</translation>
    </message>
    <message>
        <source>The identified motor agrees: the two intervals overlap.</source>
        <translation>已辨识的电机一致：两个区间重叠。</translation>
    </message>
    <message>
        <source>The identified motor disagrees: the two intervals lie apart.</source>
        <translation>已辨识的电机不一致：两个区间分离。</translation>
    </message>
    <message>
        <source>Whether a model agrees is not known: identify the motor to compare.</source>
        <translation>无法判断是否与模型一致：请辨识电机以作比较。</translation>
    </message>
    <message>
        <source>The rotor will turn in reverse at %1 rad/s (%2 r/min), about %3 turns, for %4 minutes of device time.</source>
        <translation>转子将以 %1 rad/s（%2 r/min）反转，约 %3 转，设备时间 %4 分钟。</translation>
    </message>
    <message>
        <source>The rotor will turn forward at %1 rad/s (%2 r/min), about %3 turns, for %4 minutes of device time.</source>
        <translation>转子将以 %1 rad/s（%2 r/min）正转，约 %3 转，设备时间 %4 分钟。</translation>
    </message>
    <message>
        <source>It swings around that by about %1° every %2 s, with speeds from %3 to %4 rad/s; its speed never changes sign, and the run ends where it leaves what is foreseen.</source>
        <translation>它围绕该运动每 %2 s 摆动约 %1°，转速为 %3 至 %4 rad/s；转速从不变号，一旦超出预计，运行即结束。</translation>
    </message>
    <message>
        <source>Current up to %1 A, coils up to %2 °C.</source>
        <translation>电流最大 %1 A，线圈最高 %2 °C。</translation>
    </message>
    <message>
        <source>The board ends the motion at %1 rad/s at the latest. Its gains and limits are replaced for the experiment and restored whatever happens.</source>
        <translation>控制板最迟在 %1 rad/s 时结束运动。其增益和限值在实验期间被替换，无论发生什么都会恢复。</translation>
    </message>
    <message>
        <source>ultimate gain</source>
        <translation>临界增益</translation>
    </message>
    <message>
        <source>ultimate period</source>
        <translation>临界周期</translation>
    </message>
    <message>
        <source>phase where it swung</source>
        <translation>摆动处的相位</translation>
    </message>
    <message>
        <source>at %1 rad/s; followed from there to −180°</source>
        <translation>在 %1 rad/s 处；由此推算到 −180°</translation>
    </message>
    <message>
        <source>%1 swings of %2° around the steady motion, with %3 A; their frequency scattered by %4 %.</source>
        <translation>围绕匀速运动摆动 %1 次，幅值 %2°，电流 %3 A；其频率离散 %4 %。</translation>
    </message>
    <message>
        <source>The speed stayed between %1 and %2 rad/s.</source>
        <translation>转速保持在 %1 与 %2 rad/s 之间。</translation>
    </message>
</context>
<context>
    <name>halbench::app::RestRippleWords</name>
    <message>
        <source>at rest the current ripples by about %1 A: that is the noise of the measured angle (%2) times these gains, while friction holds the rotor still</source>
        <translation>静止时电流波动约 %1 A：这是测得角度的噪声（%2）乘以这些增益，而转子被摩擦保持不动</translation>
    </message>
    <message>
        <source>at rest the current ripples by about %1 A, more than the noise of the measured angle (%2) explains: the loop may hunt; a smaller K_D or K_P calms it</source>
        <translation>静止时电流波动约 %1 A，超过测得角度的噪声（%2）所能解释的：回路可能在振荡；减小 K_D 或 K_P 可使其平静</translation>
    </message>
</context>
<context>
    <name>halbench::app::ResultHistoryView</name>
    <message>
        <source>Damping c</source>
        <translation>阻尼 c</translation>
    </message>
    <message>
        <source>Friction K_f</source>
        <translation>摩擦 K_f</translation>
    </message>
    <message>
        <source>Torque constant</source>
        <translation>转矩常数</translation>
    </message>
    <message>
        <source>Inertia J</source>
        <translation>转动惯量 J</translation>
    </message>
    <message>
        <source>%1 (given)</source>
        <translation>%1（给定）</translation>
    </message>
    <message>
        <source>good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>存疑</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>Against the first of this device: more than both intervals explain</source>
        <translation>与该设备的首个结果相比：超出两个区间所能解释的范围</translation>
    </message>
    <message>
        <source>Against the first of this device: within the intervals</source>
        <translation>与该设备的首个结果相比：在区间之内</translation>
    </message>
    <message>
        <source>simulated time</source>
        <translation>仿真时间</translation>
    </message>
    <message>
        <source>Identified values over time</source>
        <translation>辨识值随时间变化</translation>
    </message>
    <message>
        <source>The identification files (.json) of the folder, oldest first, with 95 % intervals; in brackets the drift since the first of the same device</source>
        <translation>文件夹中的辨识文件（.json），最早的在前，附 95 % 区间；括号中为相对同一设备首个结果的漂移</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Data quality</source>
        <translation>数据质量</translation>
    </message>
</context>
<context>
    <name>halbench::app::ReturnNotice</name>
    <message>
        <source>Values that differ from before</source>
        <translation>与之前不同的值</translation>
    </message>
    <message>
        <source>On the left before the connection was lost, on the right on the device now</source>
        <translation>左侧为断开前的值，右侧为设备上现在的值</translation>
    </message>
    <message>
        <source>Write them back</source>
        <translation>写回原值</translation>
    </message>
    <message>
        <source>Writes the values of before to the device and reads them back</source>
        <translation>将之前的值写入设备并读回</translation>
    </message>
    <message>
        <source>Keep the device&apos;s</source>
        <translation>保留设备上的值</translation>
    </message>
    <message>
        <source>What is on the device now counts</source>
        <translation>以设备上现在的值为准</translation>
    </message>
    <message>
        <source>Looking for it again.</source>
        <translation>正在重新查找设备。</translation>
    </message>
    <message>
        <source>Looking for it again; last time: %1.</source>
        <translation>正在重新查找设备；上次结果：%1。</translation>
    </message>
    <message>
        <source>Connection lost: %1.</source>
        <translation>连接已断开：%1。</translation>
    </message>
    <message>
        <source>Back after %1 s, disarmed.</source>
        <translation>%1 s 后恢复连接，处于未使能状态。</translation>
    </message>
    <message>
        <source>Back after %1 s, disarmed. Values that differ from before: %2.</source>
        <translation>%1 s 后恢复连接，处于未使能状态。与之前不同的值：%2 个。</translation>
    </message>
    <message>
        <source>The device may have been restarted. Nothing was written.</source>
        <translation>设备可能已重启。未写入任何值。</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>以及另外 %1 个</translation>
    </message>
    <message>
        <source>The device&apos;s values were kept.</source>
        <translation>已保留设备上的值。</translation>
    </message>
    <message>
        <source>The board&apos;s watchdog ends its motion.</source>
        <translation>控制板的看门狗会结束其运动。</translation>
    </message>
    <message>
        <source>The recording goes on with a gap.</source>
        <translation>记录将带间断继续。</translation>
    </message>
    <message>
        <source>Disconnect ends the search.</source>
        <translation>“断开”可结束搜索。</translation>
    </message>
    <message>
        <source>Its values are those of before.</source>
        <translation>其数值与之前相同。</translation>
    </message>
    <message>
        <source>The values that differed were changed since.</source>
        <translation>有差异的值此后已被更改。</translation>
    </message>
    <message>
        <source>Values that differ from before the loss: %1.</source>
        <translation>与断线前不同的值：%1。</translation>
    </message>
    <message>
        <source>The values of before were written back.</source>
        <translation>已写回之前的值。</translation>
    </message>
</context>
<context>
    <name>halbench::app::RootLocusFigure</name>
    <message>
        <source>damping ratio</source>
        <translation>阻尼比</translation>
    </message>
    <message>
        <source>gain from 0 to %1 times</source>
        <translation>增益从 0 到 %1 倍</translation>
    </message>
    <message>
        <source>imaginary part of z</source>
        <translation>z 的虚部</translation>
    </message>
    <message>
        <source>poles of the open loop</source>
        <translation>开环极点</translation>
    </message>
    <message>
        <source>zeros</source>
        <translation>零点</translation>
    </message>
    <message>
        <source>poles of the closed loop</source>
        <translation>闭环极点</translation>
    </message>
    <message>
        <source>real part of z</source>
        <translation>z 的实部</translation>
    </message>
    <message>
        <source>limit of stability</source>
        <translation>稳定界限</translation>
    </message>
    <message>
        <source>limit at gain factor</source>
        <translation>增益倍数界限</translation>
    </message>
    <message>
        <source>closed loop: %1</source>
        <translation>闭环：%1</translation>
    </message>
    <message>
        <source>Root locus</source>
        <translation>根轨迹</translation>
    </message>
</context>
<context>
    <name>halbench::app::RunOverlay</name>
    <message>
        <source>Overlay of the selected recordings</source>
        <translation>所选记录的叠加</translation>
    </message>
    <message>
        <source>Values at the cursor</source>
        <translation>光标处的值</translation>
    </message>
    <message>
        <source>What each recording has at the time of the cursor</source>
        <translation>各记录在光标时间处的值</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>At the cursor</source>
        <translation>光标处</translation>
    </message>
    <message>
        <source>Signals that all selected recordings have</source>
        <translation>所选记录共有的信号</translation>
    </message>
    <message>
        <source>What is at time zero: the first row, the trigger, or a marker that all of them have</source>
        <translation>零时刻对应：首行、触发点，或它们共有的标记</translation>
    </message>
    <message>
        <source>Time of the cursor</source>
        <translation>光标时间</translation>
    </message>
    <message>
        <source>The line in the plot and the values beside it</source>
        <translation>曲线图中的线和旁边的数值</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Aligned at</source>
        <translation>对齐于</translation>
    </message>
    <message>
        <source>Cursor</source>
        <translation>光标</translation>
    </message>
    <message>
        <source>Signal that is compared</source>
        <translation>比较的信号</translation>
    </message>
    <message>
        <source>Moment at which they are aligned</source>
        <translation>对齐时刻</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>显示范围</translation>
    </message>
    <message>
        <source>All of it, or so much about the cursor</source>
        <translation>全部，或光标周围的一段</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>%1 s about the cursor</source>
        <translation>光标周围 %1 s</translation>
    </message>
    <message>
        <source>%1 recordings are laid over each other at most</source>
        <translation>最多叠加 %1 条记录</translation>
    </message>
    <message>
        <source>start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>trigger</source>
        <translation>触发</translation>
    </message>
    <message>
        <source>marker: %1</source>
        <translation>标记：%1</translation>
    </message>
    <message>
        <source>Select recordings in the list: their curves are drawn over each other here.</source>
        <translation>在列表中选择记录：它们的曲线在此叠加绘制。</translation>
    </message>
    <message>
        <source>These recordings have nothing in common there: choose another signal, moment or time.</source>
        <translation>这些记录在那里没有共同内容：请选择其他信号、对齐点或时间。</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Compare it with a copy of it: it may lack rows, or have others.</source>
        <translation>请与其副本比较：它可能缺少数据行，或数据已不同。</translation>
    </message>
</context>
<context>
    <name>halbench::app::ShownRecording</name>
    <message>
        <source>recording</source>
        <translation>记录</translation>
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
    <message>
        <source>Last</source>
        <translation>最后</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrogramFigure</name>
    <message>
        <source>Spectrogram of %1</source>
        <translation>%1 的频谱图</translation>
    </message>
    <message>
        <source>Lines every %1 Hz, resolution %2 Hz, segments of %3 s</source>
        <translation>谱线间隔 %1 Hz，分辨率 %2 Hz，分段 %3 s</translation>
    </message>
    <message>
        <source>one every %1 s</source>
        <translation>每 %1 s 一个</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrogramRange</name>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Lowest [Hz]</source>
        <translation>最低 [Hz]</translation>
    </message>
    <message>
        <source>The lowest frequency shown; empty: all</source>
        <translation>显示的最低频率；空：全部</translation>
    </message>
    <message>
        <source>Highest [Hz]</source>
        <translation>最高 [Hz]</translation>
    </message>
    <message>
        <source>The highest frequency shown; empty: all</source>
        <translation>显示的最高频率；空：全部</translation>
    </message>
    <message>
        <source>Colours from</source>
        <translation>颜色从</translation>
    </message>
    <message>
        <source>The value of the darkest colour, in the unit of the scale; empty: by what is shown</source>
        <translation>最暗颜色对应的值，以标尺的单位表示；空：由所显示的内容决定</translation>
    </message>
    <message>
        <source>Colours to</source>
        <translation>颜色到</translation>
    </message>
    <message>
        <source>The value of the brightest colour, in the unit of the scale; empty: by what is shown</source>
        <translation>最亮颜色对应的值，以标尺的单位表示；空：由所显示的内容决定</translation>
    </message>
    <message>
        <source>The lowest frequency must be below the highest; all are shown.</source>
        <translation>最低频率必须低于最高频率；现显示全部频率。</translation>
    </message>
    <message>
        <source>The colours must begin below their end; they follow what is shown.</source>
        <translation>颜色的起点必须低于终点；现按所显示的内容确定。</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrumFigure</name>
    <message>
        <source>amplitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>rms value</source>
        <translation>有效值</translation>
    </message>
    <message>
        <source>power density</source>
        <translation>功率谱密度</translation>
    </message>
    <message>
        <source>amplitude density</source>
        <translation>幅值谱密度</translation>
    </message>
    <message>
        <source>Spectrum of %1</source>
        <translation>%1 的频谱</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Lines every %1 Hz, resolution %2 Hz, segments of %3 s</source>
        <translation>谱线间隔 %1 Hz，分辨率 %2 Hz，分段 %3 s</translation>
    </message>
    <message>
        <source>95 % interval of noise: %1 to %2 times the line</source>
        <translation>噪声的 95 % 区间：谱线的 %1 至 %2 倍</translation>
    </message>
    <message>
        <source>rms of all lines %1 %2</source>
        <translation>全部谱线的有效值 %1 %2</translation>
    </message>
    <message>
        <source>no segment reaches across the %1 gaps and %2 missing values</source>
        <translation>分段不跨越 %1 处间断和 %2 个缺失值</translation>
    </message>
    <message numerus="yes">
        <source>%Ln average(s)</source>
        <translation>
            <numerusform>%Ln 次平均</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (worth %2 independent ones)</source>
        <translation>%1（相当于 %2 次独立平均）</translation>
    </message>
</context>
<context>
    <name>halbench::app::SpectrumPanel</name>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Rectangular</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Flat top</source>
        <translation>平顶</translation>
    </message>
    <message>
        <source>Nothing to analyse yet</source>
        <translation>暂无可分析的内容</translation>
    </message>
    <message>
        <source>Shows which frequencies are in a signal of a connected device, live. Choose a device at the left, or try the simulated motor.</source>
        <translation>实时显示已连接设备的信号中包含哪些频率。请在左侧选择设备，或试用仿真电机。</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>Log frequency</source>
        <translation>频率对数</translation>
    </message>
    <message>
        <source>Logarithmic axis of the frequency</source>
        <translation>频率轴取对数</translation>
    </message>
    <message>
        <source>Log values</source>
        <translation>数值对数</translation>
    </message>
    <message>
        <source>Logarithmic axis of the values</source>
        <translation>数值轴取对数</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Keep the spectrum as it is; the data go on</source>
        <translation>保持当前频谱；数据继续</translation>
    </message>
    <message>
        <source>The arrow keys walk along the lines; Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>方向键沿谱线移动；Ctrl+C 复制图片，Ctrl+E 保存</translation>
    </message>
    <message>
        <source>What the spectrum says</source>
        <translation>频谱说明</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Whose frequencies; also by dropping a signal of the tree here</source>
        <translation>分析哪个信号；也可把树中的信号拖到此处</translation>
    </message>
    <message>
        <source>Shown as</source>
        <translation>显示为</translation>
    </message>
    <message>
        <source>Amplitude or rms value of steady sines; densities of noise, in which the length of the segments does not count</source>
        <translation>稳定正弦的幅值或有效值；噪声的密度，与分段长度无关</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>有效值</translation>
    </message>
    <message>
        <source>Power density</source>
        <translation>功率谱密度</translation>
    </message>
    <message>
        <source>Amplitude density</source>
        <translation>幅值谱密度</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Weights against leakage: Hann for most, flat top for exact amplitudes, Blackman-Harris for weak lines beside strong ones</source>
        <translation>抑制泄漏的加权：一般用 Hann，精确幅值用平顶，强线旁的弱线用 Blackman-Harris</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>The newest seconds are analysed</source>
        <translation>分析最近若干秒</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>分段</translation>
    </message>
    <message>
        <source>Longer segments part lines that are closer, more of them average noise. 0: the whole stretch for amplitudes, at least eight for densities</source>
        <translation>分段越长可分辨越近的谱线，分段越多噪声越平滑。0：幅值取整段，密度至少八段</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>重叠</translation>
    </message>
    <message>
        <source>Of neighbouring segments</source>
        <translation>相邻分段之间</translation>
    </message>
    <message>
        <source>Highest peaks</source>
        <translation>最高峰</translation>
    </message>
    <message>
        <source>Lines higher than all others within the window&apos;s main lobe</source>
        <translation>在窗主瓣内高于其他的谱线</translation>
    </message>
    <message>
        <source>Peak [Hz]</source>
        <translation>峰 [Hz]</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Value [%1]</source>
        <translation>值 [%1]</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>随时间</translation>
    </message>
    <message>
        <source>Spectrogram: spectra of the segments beside each other, in colours</source>
        <translation>频谱图：各分段的频谱并排，以颜色表示</translation>
    </message>
    <message>
        <source>The arrow keys walk from the highest value, with Shift ten times as far; Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>方向键从最大值开始移动，按住 Shift 时移动十倍；Ctrl+C 复制图片，Ctrl+E 保存</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>The colours&apos; scale in dB, re 1 of the unit</source>
        <translation>颜色标尺以 dB 表示，以单位的 1 为基准</translation>
    </message>
    <message>
        <source>Save the lines as a table (CSV), in SI units</source>
        <translation>把谱线保存为表（CSV），采用 SI 单位</translation>
    </message>
</context>
<context>
    <name>halbench::app::StopLatch</name>
    <message>
        <source>The stop cannot be released yet.</source>
        <translation>现在还不能解除停止。</translation>
    </message>
    <message>
        <source>Wait a moment, look, then release it.</source>
        <translation>请稍候，确认情况后再解除。</translation>
    </message>
</context>
<context>
    <name>halbench::app::TopBar</name>
    <message>
        <source>stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>connection lost</source>
        <translation>连接丢失</translation>
    </message>
    <message>
        <source>nothing was armed</source>
        <translation>当时未使能</translation>
    </message>
    <message>
        <source>connection lost, reconnecting</source>
        <translation>连接已断开，正在重连</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>解除</translation>
    </message>
    <message>
        <source>Takes the latched stop back and arms nothing; right after a stop it is locked (Space)</source>
        <translation>解除已锁存的停止，但不使能；刚停止后会锁定（空格键）</translation>
    </message>
</context>
<context>
    <name>halbench::app::TriggerBar</name>
    <message>
        <source>State of the trigger</source>
        <translation>触发状态</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Auto shows something after half a second even if nothing happens; Normal waits; Single stops after one event</source>
        <translation>自动：即使没有事件，半秒后也显示；正常：等待；单次：一个事件后停止</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>单次</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>信号源</translation>
    </message>
    <message>
        <source>The signal whose edge is the event, or the set-point</source>
        <translation>其边沿即为事件的信号，或设定值</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>边沿</translation>
    </message>
    <message>
        <source>Which way the source passes the level</source>
        <translation>信号源以何方向穿过电平</translation>
    </message>
    <message>
        <source>rising</source>
        <translation>上升</translation>
    </message>
    <message>
        <source>falling</source>
        <translation>下降</translation>
    </message>
    <message>
        <source>either</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>电平</translation>
    </message>
    <message>
        <source>The event is where the source passes it; the line in the plot can be dragged</source>
        <translation>信号源穿过它时即为事件；可拖动图中的线</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>迟滞</translation>
    </message>
    <message>
        <source>So far on the other side of the level the source must have been before</source>
        <translation>信号源此前须在电平另一侧超出这么多</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>The stretch of time shown of an event</source>
        <translation>每个事件显示的时间长度</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Share of the window that lies before the event</source>
        <translation>窗口中位于事件之前的比例</translation>
    </message>
    <message>
        <source>Hold-off</source>
        <translation>释抑</translation>
    </message>
    <message>
        <source>Least time from one event to the next</source>
        <translation>相邻事件的最短间隔</translation>
    </message>
    <message>
        <source>Level to the middle</source>
        <translation>电平置中</translation>
    </message>
    <message>
        <source>Sets the level half way between what the source reaches in the view, and the hysteresis to a twentieth of it</source>
        <translation>把电平置于信号源在视图中所达范围的中点，迟滞取该范围的二十分之一</translation>
    </message>
    <message>
        <source>Set-point change</source>
        <translation>设定值变化</translation>
    </message>
    <message>
        <source>the set-point changes</source>
        <translation>设定值变化</translation>
    </message>
    <message>
        <source>%1 rises through %2</source>
        <translation>%1 上升穿过 %2</translation>
    </message>
    <message>
        <source>%1 falls through %2</source>
        <translation>%1 下降穿过 %2</translation>
    </message>
    <message>
        <source>%1 passes %2</source>
        <translation>%1 穿过 %2</translation>
    </message>
    <message>
        <source>Hysteresis, window and hold-off of the trigger</source>
        <translation>触发的迟滞、窗口和释抑</translation>
    </message>
    <message>
        <source>More settings of the trigger</source>
        <translation>触发的更多设置</translation>
    </message>
    <message>
        <source>From</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>控制板</translation>
    </message>
    <message>
        <source>Reference start</source>
        <translation>参考启动</translation>
    </message>
    <message>
        <source>The board does not have it: it is derived here.</source>
        <translation>控制板没有该信号：它在此处派生。</translation>
    </message>
    <message>
        <source>Live: in the samples that are sent to the plots. Board: the board itself waits, captures up to 4 signals of the plots at the rate of its loop, 4096 rows, and they are read then</source>
        <translation>实时：在发送到曲线图的样本中查找。控制板：由控制板自己等待，以其回路速率捕获曲线图中最多 4 个信号，4096 行，然后读取</translation>
    </message>
    <message>
        <source>Live: in the samples that are sent to the plots. %1</source>
        <translation>实时：在发送到曲线图的样本中查找。%1</translation>
    </message>
    <message>
        <source>The board waits for its event and shows nothing without one.</source>
        <translation>控制板等待其事件，没有事件就不显示任何内容。</translation>
    </message>
    <message>
        <source>The board looks for one direction only.</source>
        <translation>控制板只查找一个方向。</translation>
    </message>
    <message>
        <source>The board has none: every passing of the level is an event.</source>
        <translation>控制板没有滞回：每次越过电平都是事件。</translation>
    </message>
    <message>
        <source>The board has none: it waits again once its capture is read.</source>
        <translation>控制板没有释抑：其捕获读完后再次等待。</translation>
    </message>
    <message>
        <source>the reference starts</source>
        <translation>参考启动</translation>
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
    <message>
        <source>Largest Ms</source>
        <translation>最大 Ms</translation>
    </message>
    <message>
        <source>Peak of the sensitivity that is not exceeded: 1.4 is calm, 2 lively. Numbers says whether it is what keeps the error from being less</source>
        <translation>不超过的灵敏度峰值：1.4 为平稳，2 为活跃。“数值”页说明是否是它使误差无法更小</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>电流限值</translation>
    </message>
    <message>
        <source>the board&apos;s</source>
        <translation>同控制板</translation>
    </message>
    <message>
        <source>What a step of the height below may ask for; at most what the board gives</source>
        <translation>下面高度的阶跃可要求的电流；至多为控制板所能给出的</translation>
    </message>
    <message>
        <source>In a step of</source>
        <translation>阶跃高度</translation>
    </message>
    <message>
        <source>The largest step of the reference that shall not reach the current limit</source>
        <translation>不应达到电流限值的最大参考值阶跃</translation>
    </message>
    <message>
        <source>Where the loop swings, as the relay experiment measures it; empty: as the model says</source>
        <translation>回路振荡之处，由继电实验测得；留空：按模型</translation>
    </message>
    <message>
        <source>Ultimate gain</source>
        <translation>临界增益</translation>
    </message>
    <message>
        <source>Ultimate period</source>
        <translation>临界周期</translation>
    </message>
</context>
<context>
    <name>halbench::app::TuneNumberWords</name>
    <message>
        <source>infinite</source>
        <translation>无穷大</translation>
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
        <source>With friction and current limit</source>
        <translation>含摩擦和电流限制</translation>
    </message>
    <message>
        <source>Step of %1</source>
        <translation>%1 阶跃</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>at rest %1 from the set-point by its own sensors, allowed are %2</source>
        <translation>静止时按自身传感器距设定值 %1，允许 %2</translation>
    </message>
    <message>
        <source>at rest %1 from the set-point by its own sensors, %2 more than allowed</source>
        <translation>静止时按自身传感器距设定值 %1，超出允许值 %2</translation>
    </message>
    <message>
        <source>overshoot %1 %, %2 % more than allowed</source>
        <translation>超调 %1 %，超出允许值 %2 %</translation>
    </message>
    <message>
        <source>farthest from the prediction, %1, after %2 s</source>
        <translation>与预测相差最大处为 %1，在 %2 s</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1: at its bound</source>
        <translation>%1：达到界限</translation>
    </message>
    <message>
        <source>At its bound: this is what keeps the error after a load from being less</source>
        <translation>达到界限：正是它使负载之后的误差无法更小</translation>
    </message>
    <message>
        <source>Peak of sensitivity, Ms</source>
        <translation>灵敏度峰值 Ms</translation>
    </message>
    <message>
        <source>Current in a step of %1</source>
        <translation>%1 阶跃的电流</translation>
    </message>
    <message>
        <source>rise %1, %2 overshoot, within 2 % after %3</source>
        <translation>上升 %1，超调 %2，%3 后保持在 2 % 以内</translation>
    </message>
    <message>
        <source>Disturbances near the crossover are made so many times larger; at most 2 is usual</source>
        <translation>穿越频率附近的扰动被放大的倍数；通常至多为 2</translation>
    </message>
    <message>
        <source>Noise gain</source>
        <translation>噪声增益</translation>
    </message>
    <message>
        <source>Current that flickers for each radian of noise in the angle</source>
        <translation>角度噪声每弧度引起的电流波动</translation>
    </message>
    <message>
        <source>Largest linear step</source>
        <translation>最大线性阶跃</translation>
    </message>
    <message>
        <source>A larger one reaches the current limit</source>
        <translation>更大的阶跃会达到电流限制</translation>
    </message>
    <message>
        <source>One more sample of delay</source>
        <translation>时延多一个采样</translation>
    </message>
    <message>
        <source>stays stable</source>
        <translation>仍然稳定</translation>
    </message>
    <message>
        <source>Whether the loop bears a current that comes one sample later</source>
        <translation>回路能否承受电流晚一个采样到来</translation>
    </message>
    <message>
        <source>%1 at %2 Hz, to %3 %</source>
        <translation>%1，%2 Hz，精度 %3 %</translation>
    </message>
    <message>
        <source>Integral ends a rest</source>
        <translation>积分结束静止</translation>
    </message>
    <message>
        <source>after %1 s</source>
        <translation>%1 s 之后</translation>
    </message>
    <message>
        <source>never</source>
        <translation>永不</translation>
    </message>
    <message>
        <source>From half of the friction band; then the rotor jumps and may rest again: it hunts</source>
        <translation>从半个摩擦带处算起；然后转子跳动并可能再次停住：爬行抖动</translation>
    </message>
    <message>
        <source>Limit cycle</source>
        <translation>极限环</translation>
    </message>
    <message>
        <source>A swing that friction and the current limit let the loop keep up, by harmonic balance</source>
        <translation>摩擦和电流限制使回路得以维持的振荡，用谐波平衡求得</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>not predicted</source>
        <translation>未预测</translation>
    </message>
    <message>
        <source>The micro-step assist, or a motor without friction, is not in the balance</source>
        <translation>谐波平衡不含微步辅助，也不适用于无摩擦的电机</translation>
    </message>
    <message>
        <source>Swing that grows</source>
        <translation>增长的阈值</translation>
    </message>
    <message>
        <source>A smaller one comes to rest</source>
        <translation>更小的会停下</translation>
    </message>
    <message>
        <source>The rotor will turn by %1, in %2; the board ends it at %3 or %4.</source>
        <translation>转子将转动 %1，用时 %2；控制板在 %3 或 %4 处结束运动。</translation>
    </message>
    <message>
        <source>After each step the rotor will turn by %1, to and fro, in %2; the board ends it at %3 or %4.</source>
        <translation>每一步之后，转子将来回转动 %1，用时 %2；控制板在 %3 或 %4 处结束运动。</translation>
    </message>
    <message>
        <source>Peak under a load worth %1 A</source>
        <translation>相当于 %1 A 的负载下的峰值</translation>
    </message>
    <message>
        <source>How far the load moves the linear loop from its reference</source>
        <translation>负载使线性回路偏离参考值的最大距离</translation>
    </message>
    <message>
        <source>Recovered from it</source>
        <translation>从中恢复</translation>
    </message>
    <message>
        <source>not in the time that is shown</source>
        <translation>未在所示时间内</translation>
    </message>
    <message>
        <source>From then on the angle stays within a tenth of the peak around where it ends</source>
        <translation>此后角度一直保持在终值附近峰值十分之一以内</translation>
    </message>
    <message>
        <source>not there after %1</source>
        <translation>%1 后仍未到达</translation>
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
    <message>
        <source>Before the apply</source>
        <translation>应用之前</translation>
    </message>
    <message>
        <source>5 % to 95 %</source>
        <translation>5 % 至 95 %</translation>
    </message>
    <message>
        <source>Of the motors that the identification&apos;s uncertainty allows; not known without one</source>
        <translation>辨识不确定度所允许的电机；没有不确定度则未知</translation>
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
        <source>Keep</source>
        <translation>保留</translation>
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
        <source>Saved as %1</source>
        <translation>已保存为 %1</translation>
    </message>
    <message>
        <source>Choose a method to design anew for the motor as it is now.</source>
        <translation>选择一种方法，即可针对电机的当前状态重新设计。</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>Open loop</source>
        <translation>开环</translation>
    </message>
    <message>
        <source>Step of %1</source>
        <translation>%1 阶跃</translation>
    </message>
    <message>
        <source>A large step with friction and current limit</source>
        <translation>带摩擦和电流限制的大阶跃</translation>
    </message>
    <message>
        <source>The step of the linear loop</source>
        <translation>线性回路的阶跃</translation>
    </message>
    <message>
        <source>Every predicted figure, margins with their interval</source>
        <translation>所有预测值，裕度附区间</translation>
    </message>
    <message>
        <source>The measured move over its prediction; there is one after Apply and verify</source>
        <translation>实测运动与其预测；“应用并验证”之后才有</translation>
    </message>
    <message>
        <source>Within the predicted band</source>
        <translation>在预测范围之内</translation>
    </message>
    <message>
        <source>Outside the predicted band</source>
        <translation>超出预测范围</translation>
    </message>
    <message>
        <source>The new gains run until the device is switched off.</source>
        <translation>新增益在设备断电前有效。</translation>
    </message>
    <message>
        <source>To have them after that too: Save in the device, in the Parameters panel.</source>
        <translation>若断电后也要保留：在“参数”面板中选择“保存到设备”。</translation>
    </message>
    <message>
        <source>The new gains stay until the device is switched off or, for a simulated one, disconnected; Save in the device, in the Parameters panel, keeps them longer</source>
        <translation>新增益保留到设备断电为止，仿真设备则到断开为止；在“参数”面板中选择“保存到设备”可长期保留</translation>
    </message>
    <message>
        <source>The new gains run until the simulated device is disconnected.</source>
        <translation>新增益在仿真设备断开前有效。</translation>
    </message>
    <message>
        <source>This verification is running</source>
        <translation>本次验证正在进行</translation>
    </message>
    <message>
        <source>Keep the new gains, or restore those from before.</source>
        <translation>请保留新增益，或恢复之前的增益。</translation>
    </message>
    <message>
        <source>Nothing verified yet</source>
        <translation>尚未验证</translation>
    </message>
    <message>
        <source>Within the predicted band, but these gains do not run any more</source>
        <translation>在预测范围内，但这些增益已不再运行</translation>
    </message>
    <message>
        <source>Designs</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Designs kept under a name, beside the proposed one</source>
        <translation>以名称保留的设计，与当前建议并列</translation>
    </message>
    <message>
        <source>Bode, Nyquist and Nichols plot, and sensitivity</source>
        <translation>Bode 图、Nyquist 图、Nichols 图和灵敏度</translation>
    </message>
    <message>
        <source>Open a measured response</source>
        <translation>打开测得的响应</translation>
    </message>
    <message>
        <source>Response (*.json)</source>
        <translation>频率响应 (*.json)</translation>
    </message>
    <message>
        <source>The measured response is drawn into the open loop, with the proposed gains.</source>
        <translation>测得的响应已按建议的增益画入开环图。</translation>
    </message>
    <message>
        <source>%1 of its %2 frequencies are coherent; the others are hollow.</source>
        <translation>%2 个频率中有 %1 个相干；其余为空心点。</translation>
    </message>
    <message>
        <source>Measured response…</source>
        <translation>测得的响应…</translation>
    </message>
    <message>
        <source>The open loop shows predictions alone again</source>
        <translation>开环图重新只显示预测</translation>
    </message>
    <message>
        <source>Draw what identify --frequency measured into the open loop, with the gains proposed here: no model of the motor is in it</source>
        <translation>把 identify --frequency 测得的响应按此处建议的增益画入开环图：其中不含电机模型</translation>
    </message>
    <message>
        <source>Gains (*.json);;The law as C (*.c)</source>
        <translation>增益 (*.json);;C 语言控制律 (*.c)</translation>
    </message>
    <message>
        <source>kept on %1</source>
        <translation>已保留于 %1</translation>
    </message>
    <message>
        <source>This project has them as the design &apos;%1&apos;, to be applied again after that.</source>
        <translation>本项目已将其存为设计“%1”，之后可再次应用。</translation>
    </message>
    <message>
        <source>This project has them as the design &apos;%1&apos;.</source>
        <translation>本项目已将其存为设计“%1”。</translation>
    </message>
    <message>
        <source>applied on %1</source>
        <translation>已应用于 %1</translation>
    </message>
    <message>
        <source>The gains that were applied on %1 were neither kept nor restored.</source>
        <translation>应用于 %1 的增益既未保留也未恢复。</translation>
    </message>
    <message>
        <source>The gains that were kept on %1 were left with it.</source>
        <translation>在 %1 上保留的增益留在了该设备上。</translation>
    </message>
    <message>
        <source>A simulated device is new whenever it is connected and has them no more.</source>
        <translation>模拟设备每次连接都是全新的，不再有这些增益。</translation>
    </message>
    <message>
        <source>It has them until it is switched off.</source>
        <translation>断电前设备仍有这些增益。</translation>
    </message>
    <message>
        <source>This project has them as the design &apos;%1&apos;: Take up, then Apply and verify, runs them again.</source>
        <translation>本项目已将其存为设计“%1”：先“采用”，再“应用并验证”，即可重新运行。</translation>
    </message>
    <message>
        <source>not judged: the project&apos;s entry cannot be read</source>
        <translation>未评判：无法读取项目中的条目</translation>
    </message>
    <message>
        <source>not judged yet</source>
        <translation>尚未评判</translation>
    </message>
    <message>
        <source>not judged: %1</source>
        <translation>未评判：%1</translation>
    </message>
    <message>
        <source>All gains at once, then a step that must go as predicted; Esc stops it</source>
        <translation>一次写入全部增益，然后做一次阶跃，它必须与预测一致；Esc 停止</translation>
    </message>
    <message>
        <source>Take up %1</source>
        <translation>采用 %1</translation>
    </message>
    <message>
        <source>Gains by %1</source>
        <translation>增益来源：%1</translation>
    </message>
    <message>
        <source>Edit the gains</source>
        <translation>编辑增益</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>编辑 %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Move a pole</source>
        <translation>移动极点</translation>
    </message>
    <message>
        <source>Move the crossover</source>
        <translation>移动穿越频率</translation>
    </message>
    <message>
        <source>Move the phase margin</source>
        <translation>移动相位裕度</translation>
    </message>
    <message>
        <source>Gains from the project: %1.</source>
        <translation>来自项目的增益：%1。</translation>
    </message>
    <message>
        <source>Within the predicted band: the gains that were applied, not those shown now</source>
        <translation>在预测范围内：指已应用的增益，而非现在显示的增益</translation>
    </message>
    <message>
        <source>In small steps</source>
        <translation>以小步进行</translation>
    </message>
    <message>
        <source>From the gains that run to the new ones in steps that change K_P and K_P + K_D/T by half at most, each judged before it is written and proved by a move; if one leaves its band, the gains from before run again</source>
        <translation>从运行中的增益到新增益，每步使 K_P 和 K_P + K_D/T 至多变化一半，每步在写入前被判断，并由一次运动验证；若某次运动离开其范围，则重新运行之前的增益</translation>
    </message>
    <message>
        <source>Outside the predicted band: the gains that were applied, not those shown now</source>
        <translation>超出预测范围：指已应用的增益，而非现在显示的增益</translation>
    </message>
    <message>
        <source>Motor (SI, 95 %): %1</source>
        <translation>电机（SI，95 %）：%1</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>假如</translation>
    </message>
    <message>
        <source>A recorded move, and what the proposed gains would have made of it</source>
        <translation>记录的运动，以及建议的增益会使它成为怎样</translation>
    </message>
    <message>
        <source>Counted from where the rotor is when it starts</source>
        <translation>从转子起动时所在的位置算起</translation>
    </message>
    <message>
        <source>Remove the response</source>
        <translation>移除频率响应</translation>
    </message>
    <message>
        <source>More gain would be unstable: it stays below.</source>
        <translation>增益再大就不稳定：保持在其下。</translation>
    </message>
    <message>
        <source>Open a recorded move</source>
        <translation>打开记录的运动</translation>
    </message>
    <message>
        <source>Recording (*.csv *.mf4)</source>
        <translation>记录 (*.csv *.mf4)</translation>
    </message>
    <message>
        <source>Open the gains that ran</source>
        <translation>打开当时运行的增益</translation>
    </message>
    <message>
        <source>Gains (*.json)</source>
        <translation>增益 (*.json)</translation>
    </message>
    <message>
        <source>The recording is shown once there is an identified motor.</source>
        <translation>有了辨识的电机之后显示该记录。</translation>
    </message>
    <message>
        <source>What if: %1</source>
        <translation>假如：%1</translation>
    </message>
    <message>
        <source>Choose the file of the gains that ran then.</source>
        <translation>请选择当时运行的增益的文件。</translation>
    </message>
    <message>
        <source>Gains that ran…</source>
        <translation>当时的增益…</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>扰动</translation>
    </message>
    <message>
        <source>What a load that appears at once does to the angle</source>
        <translation>突然出现的负载对角度的影响</translation>
    </message>
    <message>
        <source>Open gains</source>
        <translation>打开增益</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>Gains of %1.</source>
        <translation>来自 %1 的增益。</translation>
    </message>
    <message>
        <source>Open gains…</source>
        <translation>打开增益…</translation>
    </message>
    <message>
        <source>Gains of a file become the proposed ones; they are judged for this motor before they can be applied</source>
        <translation>文件中的增益成为建议的增益；应用之前会针对这台电机进行评判</translation>
    </message>
    <message>
        <source>These gains cannot be applied: %1. %2.</source>
        <translation>这些增益不能应用：%1。%2。</translation>
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
        <source>friction band</source>
        <translation>摩擦带</translation>
    </message>
    <message>
        <source>Predicted step with friction and current limit,</source>
        <translation>预测阶跃（含摩擦和电流限制），</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Verification move</source>
        <translation>验证运动</translation>
    </message>
    <message>
        <source>Predicted step of %1, linear loop</source>
        <translation>预测的 %1 阶跃，线性回路</translation>
    </message>
    <message>
        <source>error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>allowed %1</source>
        <translation>允许 %1</translation>
    </message>
    <message>
        <source>friction band %1</source>
        <translation>摩擦带 %1</translation>
    </message>
    <message>
        <source>set-point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>measured, not coherent</source>
        <translation>实测，不相干</translation>
    </message>
    <message>
        <source>5 % to 95 % of the motors</source>
        <translation>5 % 至 95 % 的电机</translation>
    </message>
    <message>
        <source>with the proposed gains</source>
        <translation>用建议的增益</translation>
    </message>
    <message>
        <source>nine tenths of such moves</source>
        <translation>此类运动的十分之九</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Recorded move</source>
        <translation>记录的运动</translation>
    </message>
    <message>
        <source>angle from the reference</source>
        <translation>相对参考值的角度</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>峰值</translation>
    </message>
    <message>
        <source>recovered after</source>
        <translation>恢复时间</translation>
    </message>
    <message>
        <source>other crossings</source>
        <translation>其他穿越</translation>
    </message>
    <message>
        <source>circled %1 times; unstable poles of L: %2</source>
        <translation>被环绕 %1 次；L 的不稳定极点：%2</translation>
    </message>
    <message>
        <source>Load worth %1 A, linear loop</source>
        <translation>相当于 %1 A 的负载，线性回路</translation>
    </message>
</context>
<context>
    <name>halbench::app::UnkeptBar</name>
    <message>
        <source>The project stays open, because what is not saved could not be kept: %1</source>
        <translation>项目保持打开，因为未保存的内容无法保留：%1</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Writes it once more and goes on</source>
        <translation>再写一次并继续</translation>
    </message>
    <message>
        <source>Save project as…</source>
        <translation>项目另存为…</translation>
    </message>
    <message>
        <source>Saves it elsewhere and goes on</source>
        <translation>另存到别处并继续</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Goes on; what was not saved is lost</source>
        <translation>继续；未保存的内容将丢失</translation>
    </message>
</context>
<context>
    <name>halbench::app::WhatIfPage</name>
    <message>
        <source>No recording is chosen</source>
        <translation>未选择记录</translation>
    </message>
    <message>
        <source>A recorded move is shown with what the proposed gains would have made of it, if the identified motor explains it.</source>
        <translation>显示记录的运动以及建议的增益会使它成为怎样，前提是辨识的电机能解释它。</translation>
    </message>
    <message>
        <source>Open a recorded move</source>
        <translation>打开记录的运动</translation>
    </message>
    <message>
        <source>Another move…</source>
        <translation>另一次运动…</translation>
    </message>
    <message>
        <source>Choose another recording</source>
        <translation>选择另一个记录</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>This page is empty again; the recording stays</source>
        <translation>此页重新变为空；记录保留</translation>
    </message>
    <message>
        <source>%1: withheld, what the proposed gains would make of it</source>
        <translation>%1：不给出建议的增益会使它成为怎样</translation>
    </message>
    <message>
        <source>%1 is being judged</source>
        <translation>正在判断 %1</translation>
    </message>
    <message>
        <source>%1 waits for an identified motor</source>
        <translation>%1 等待辨识的电机</translation>
    </message>
    <message>
        <source>%1: the identified loop explains the recorded move</source>
        <translation>%1：辨识的回路能解释记录的运动</translation>
    </message>
    <message>
        <source>%1: doubtful, as said below</source>
        <translation>%1：存疑，原因见下</translation>
    </message>
    <message>
        <source>%1 % of the recorded motion lie outside the band of the gains that ran.</source>
        <translation>记录的运动有 %1 % 位于当时运行的增益的范围之外。</translation>
    </message>
    <message>
        <source>The proposed gains are those that ran: the recording is what they make of it.</source>
        <translation>建议的增益就是当时运行的增益：记录即其结果。</translation>
    </message>
</context>
<context>
    <name>halbench::app::WhatIfWords</name>
    <message>
        <source>What the proposed gains would make of this move is not said: %1</source>
        <translation>不说明建议的增益会使此运动怎样：%1</translation>
    </message>
    <message>
        <source>With the proposed gains this move would overshoot by %1 instead of %2 and end %3 from its set-point instead of %4.</source>
        <translation>用建议的增益，此运动会超调 %1 而不是 %2，结束时距设定值 %3 而不是 %4。</translation>
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
    <name>halbench::app::XyPanel</name>
    <message>
        <source>Nothing to show yet</source>
        <translation>暂无可显示的内容</translation>
    </message>
    <message>
        <source>Shows two signals of a connected device against each other, at first the Hall sensors with their ellipse. Choose a device at the left, or try the simulated motor.</source>
        <translation>把已连接设备的两个信号相互对照显示，默认为霍尔传感器及其椭圆。请在左侧选择设备，或试用仿真电机。</translation>
    </message>
    <message>
        <source>The arrow keys walk along the points; Ctrl+C copies the picture, Ctrl+E saves it</source>
        <translation>方向键沿各点移动；Ctrl+C 复制图片，Ctrl+E 保存</translation>
    </message>
    <message>
        <source>What the ellipse says</source>
        <translation>椭圆说明</translation>
    </message>
    <message>
        <source>Fitted ellipse</source>
        <translation>拟合椭圆</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>横轴</translation>
    </message>
    <message>
        <source>The signal of the horizontal axis; also by dropping one of the tree here</source>
        <translation>横轴的信号；也可把树中的信号拖到此处</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>纵轴</translation>
    </message>
    <message>
        <source>The signal of the vertical axis; also by dropping one of the tree here</source>
        <translation>纵轴的信号；也可把树中的信号拖到此处</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>The newest seconds are shown</source>
        <translation>显示最近若干秒</translation>
    </message>
    <message>
        <source>Ellip&amp;se</source>
        <translation>椭圆(&amp;S)</translation>
    </message>
    <message>
        <source>Fits an ellipse through the points; they must go round it several times (Alt+E)</source>
        <translation>用各点拟合椭圆；须转过多圈 (Alt+E)</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 对 %2</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>ellipse</source>
        <translation>椭圆</translation>
    </message>
    <message>
        <source>Centre of %1</source>
        <translation>%1 的中心</translation>
    </message>
    <message>
        <source>Amplitude of %1</source>
        <translation>%1 的幅值</translation>
    </message>
    <message>
        <source>Ratio of the amplitudes</source>
        <translation>幅值之比</translation>
    </message>
    <message>
        <source>Phase beyond 90°</source>
        <translation>超出 90° 的相位</translation>
    </message>
    <message>
        <source>Longest and shortest radius %1 and %2 %3</source>
        <translation>最长与最短半径 %1 和 %2 %3</translation>
    </message>
    <message>
        <source>rms distance of the points from the ellipse %1 % of the amplitude</source>
        <translation>各点到椭圆的均方根距离为幅值的 %1 %</translation>
    </message>
    <message>
        <source>Save all points as a table (CSV), in SI units</source>
        <translation>把所有点保存为表（CSV），采用 SI 单位</translation>
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
    <message>
        <source>Cursor pair</source>
        <translation>光标对</translation>
    </message>
    <message>
        <source>Pair that measures</source>
        <translation>测量的光标对</translation>
    </message>
    <message>
        <source>Name of the cursor pair</source>
        <translation>光标对的名称</translation>
    </message>
    <message>
        <source>Name of the pair that measures; a pair with a name is kept in the project (F2)</source>
        <translation>正在测量的一对的名称；有名称的光标对随项目保存（F2）</translation>
    </message>
    <message>
        <source>Pair that measures: %1. N adds one, P chooses the next, F2 names it; the others are drawn faint</source>
        <translation>测量的光标对：%1。N 添加一对，P 选择下一对，F2 命名；其余各对以淡线显示</translation>
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
    <message>
        <source>Drag: %1</source>
        <translation>拖动：%1</translation>
    </message>
    <message>
        <source>Ctrl and the arrow keys move: %1.</source>
        <translation>Ctrl 加方向键可移动：%1。</translation>
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
    <message>
        <source>%1 (right)</source>
        <translation>%1（右）</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::LiveLegend</name>
    <message>
        <source>Legend with live values</source>
        <translation>带实时数值的图例</translation>
    </message>
    <message>
        <source>The chosen curve</source>
        <translation>选中的曲线</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>To the left axis</source>
        <translation>放到左轴</translation>
    </message>
    <message>
        <source>To the right axis</source>
        <translation>放到右轴</translation>
    </message>
    <message>
        <source>To the plot above</source>
        <translation>移到上方的曲线图</translation>
    </message>
    <message>
        <source>To the plot below</source>
        <translation>移到下方的曲线图</translation>
    </message>
    <message>
        <source>Remove from the plot</source>
        <translation>从曲线图中移除</translation>
    </message>
    <message>
        <source>Into a plot of its own</source>
        <translation>移到它自己的曲线图</translation>
    </message>
    <message>
        <source>To the plot at the left</source>
        <translation>移到左边的曲线图</translation>
    </message>
    <message>
        <source>To the plot at the right</source>
        <translation>移到右边的曲线图</translation>
    </message>
    <message>
        <source>Into a plot of its own at the right</source>
        <translation>移到右侧它自己的曲线图</translation>
    </message>
    <message>
        <source>Space hides or shows the chosen curve, R puts it on the other axis, U offers its units, Ctrl and an arrow key puts it into the plot on that side, Ctrl+Shift+Down into one of its own, Ctrl+Shift+Right into one beside, Delete removes it from the plot.</source>
        <translation>空格键隐藏或显示选中的曲线，R 把它放到另一个轴，U 给出它可用的单位，Ctrl 加方向键把它移到那一侧的曲线图，Ctrl+Shift+下移到它自己的曲线图，Ctrl+Shift+右移到旁边它自己的曲线图，Delete 把它从曲线图中移除。</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
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
        <source>Plot of %1, at the right %2</source>
        <translation>%1 的曲线图，右轴为 %2</translation>
    </message>
    <message>
        <source>Arrow keys move a cursor or scroll, plus and minus zoom the time, with Ctrl the values, Space pauses, F fits, Insert adds signals.</source>
        <translation>方向键移动光标或滚动，加号和减号缩放时间，按住 Ctrl 则缩放数值，空格键暂停，F 使其适应，Insert 添加信号。</translation>
    </message>
    <message>
        <source>%1, column %2</source>
        <translation>%1，第 %2 列</translation>
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
        <source>Following, %1 s</source>
        <translation>跟随中，%1 s</translation>
    </message>
    <message>
        <source>Scrolled; press End to follow</source>
        <translation>已滚动；按 End 键跟随</translation>
    </message>
    <message>
        <source>Triggered view; press End to follow</source>
        <translation>触发视图；按 End 跟随</translation>
    </message>
    <message>
        <source>Keep as reference</source>
        <translation>保留为参考</translation>
    </message>
    <message>
        <source>What is shown stays as faint curves below the live ones</source>
        <translation>所显示的内容保留为实时曲线下方的浅色曲线</translation>
    </message>
    <message>
        <source>Remove the reference</source>
        <translation>移除参考</translation>
    </message>
    <message>
        <source>The faint curves go</source>
        <translation>浅色曲线消失</translation>
    </message>
    <message>
        <source>what was shown</source>
        <translation>曾显示的内容</translation>
    </message>
    <message>
        <source>Remove the reference: %1</source>
        <translation>移除参考：%1</translation>
    </message>
    <message>
        <source>New cursor pair</source>
        <translation>新建光标对</translation>
    </message>
    <message>
        <source>Two more cursors, in view; the pairs before stay where they are, faint</source>
        <translation>在视图中再放两个光标；先前的各对留在原处，以淡线显示</translation>
    </message>
    <message>
        <source>Remove the cursor pair</source>
        <translation>移除光标对</translation>
    </message>
    <message>
        <source>The pair that measures goes</source>
        <translation>移除正在测量的一对</translation>
    </message>
    <message>
        <source>Next cursor pair</source>
        <translation>下一对光标</translation>
    </message>
    <message>
        <source>The next pair measures</source>
        <translation>由下一对测量</translation>
    </message>
    <message>
        <source>Previous cursor pair</source>
        <translation>上一对光标</translation>
    </message>
    <message>
        <source>The pair before measures</source>
        <translation>由上一对测量</translation>
    </message>
    <message>
        <source>Name the cursor pair</source>
        <translation>命名光标对</translation>
    </message>
    <message>
        <source>A name for the pair that measures; the project keeps it</source>
        <translation>为正在测量的一对命名；名称随项目保存</translation>
    </message>
    <message>
        <source>Go to the cursor pair</source>
        <translation>转到光标对</translation>
    </message>
    <message>
        <source>Show the stretch of time around the pair that measures</source>
        <translation>显示正在测量的一对周围的时间段</translation>
    </message>
    <message>
        <source>Bring the cursor pair here</source>
        <translation>将光标对移到此处</translation>
    </message>
    <message>
        <source>The pair that measures comes into view</source>
        <translation>正在测量的一对移入视图</translation>
    </message>
    <message>
        <source>A pair needs a name; it is still called %1</source>
        <translation>光标对需要名称；仍名为 %1</translation>
    </message>
    <message>
        <source>There is a pair %1 already; this one is still called %2</source>
        <translation>已有名为 %1 的光标对；这一对仍名为 %2</translation>
    </message>
    <message>
        <source>Own time axis, paused</source>
        <translation>自己的时间轴，已暂停</translation>
    </message>
    <message>
        <source>Own time axis, following, %1 s</source>
        <translation>自己的时间轴，跟随，%1 s</translation>
    </message>
    <message>
        <source>Own time axis, scrolled; press End to follow</source>
        <translation>自己的时间轴，已滚动；按 End 跟随</translation>
    </message>
    <message>
        <source>Time axis of %1</source>
        <translation>%1 的时间轴</translation>
    </message>
    <message>
        <source>Own time axis</source>
        <translation>自己的时间轴</translation>
    </message>
    <message>
        <source>The plot zooms and scrolls by itself, with its own time below it; again: with the others</source>
        <translation>曲线图独立缩放和滚动，时间显示在其下方；再按一次则与其他曲线图联动</translation>
    </message>
    <message>
        <source>One time axis for all plots</source>
        <translation>所有曲线图共用一个时间轴</translation>
    </message>
    <message>
        <source>Plots with their own time axis share the others&apos; again</source>
        <translation>有自己时间轴的曲线图重新共用其他曲线图的时间轴</translation>
    </message>
    <message>
        <source>Time axis of column %1</source>
        <translation>第 %1 列的时间轴</translation>
    </message>
    <message>
        <source>Time axis</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Plot to the right</source>
        <translation>曲线图移到右边</translation>
    </message>
    <message>
        <source>The plot goes into the column at the right; beyond the last one into a new column</source>
        <translation>该曲线图移到右边的一列；越过最后一列时移到新的一列</translation>
    </message>
    <message>
        <source>Plot to the left</source>
        <translation>曲线图移到左边</translation>
    </message>
    <message>
        <source>The plot goes into the column at the left; beyond the first one into a new column</source>
        <translation>该曲线图移到左边的一列；越过第一列时移到新的一列</translation>
    </message>
    <message>
        <source>New plot at the right</source>
        <translation>在右侧新建曲线图</translation>
    </message>
    <message>
        <source>An empty plot in a column of its own</source>
        <translation>在自己的一列中的空曲线图</translation>
    </message>
    <message>
        <source>Remove the plot</source>
        <translation>移除该曲线图</translation>
    </message>
    <message>
        <source>The plot goes with its curves; a column goes with its last plot</source>
        <translation>该曲线图及其曲线一并移除；一列随其最后一个曲线图消失</translation>
    </message>
    <message>
        <source>Marker with a note</source>
        <translation>带备注的标记</translation>
    </message>
    <message>
        <source>Type the note of the chosen marker, of the one at this moment, or of a new one</source>
        <translation>输入选中标记、此刻的标记或新标记的备注</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>下一个标记</translation>
    </message>
    <message>
        <source>Choose the next marker and bring it into view</source>
        <translation>选择下一个标记并移入视图</translation>
    </message>
    <message>
        <source>Previous marker</source>
        <translation>上一个标记</translation>
    </message>
    <message>
        <source>Choose the marker before and bring it into view</source>
        <translation>选择上一个标记并移入视图</translation>
    </message>
    <message>
        <source>Remove the marker</source>
        <translation>移除标记</translation>
    </message>
    <message>
        <source>The chosen marker goes</source>
        <translation>选中的标记被移除</translation>
    </message>
    <message>
        <source>List of markers</source>
        <translation>标记列表</translation>
    </message>
    <message>
        <source>All markers with their notes; choose one</source>
        <translation>全部标记及其备注；选择一个</translation>
    </message>
    <message>
        <source>Zoom the values in</source>
        <translation>放大数值</translation>
    </message>
    <message>
        <source>Show fewer values of the plot with the focus, around the middle</source>
        <translation>显示具有焦点的曲线图的较小数值范围，围绕中间</translation>
    </message>
    <message>
        <source>Zoom the values out</source>
        <translation>缩小数值</translation>
    </message>
    <message>
        <source>Show more values of the plot with the focus</source>
        <translation>显示具有焦点的曲线图的较大数值范围</translation>
    </message>
    <message>
        <source>Fit the values</source>
        <translation>适应数值</translation>
    </message>
    <message>
        <source>The value axes of the plot with the focus follow its data again</source>
        <translation>具有焦点的曲线图的数值轴重新跟随其数据</translation>
    </message>
    <message>
        <source>Taller plot</source>
        <translation>曲线图加高</translation>
    </message>
    <message>
        <source>The plot gets taller, the others of its column shorter</source>
        <translation>该曲线图加高，同列的其他曲线图变矮</translation>
    </message>
    <message>
        <source>Shorter plot</source>
        <translation>曲线图变矮</translation>
    </message>
    <message>
        <source>The plot gets shorter, the others of its column taller</source>
        <translation>该曲线图变矮，同列的其他曲线图加高</translation>
    </message>
    <message>
        <source>Wider column</source>
        <translation>列加宽</translation>
    </message>
    <message>
        <source>The column of the plot gets wider, the others narrower</source>
        <translation>该曲线图所在的列加宽，其他列变窄</translation>
    </message>
    <message>
        <source>Narrower column</source>
        <translation>列变窄</translation>
    </message>
    <message>
        <source>The column of the plot gets narrower, the others wider</source>
        <translation>该曲线图所在的列变窄，其他列加宽</translation>
    </message>
    <message>
        <source>Equal sizes</source>
        <translation>大小相等</translation>
    </message>
    <message>
        <source>All columns equally wide, all plots of a column equally tall</source>
        <translation>各列等宽，同列各曲线图等高</translation>
    </message>
    <message>
        <source>Paused, %1 s kept</source>
        <translation>已暂停，此后保留 %1 s</translation>
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
    <message>
        <source>Time of day where this window runs</source>
        <translation>本窗口所在计算机的时间</translation>
    </message>
    <message>
        <source>Time on the device&apos;s own clock, as in its recordings</source>
        <translation>设备自身时钟的时间，与其记录一致</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>时钟</translation>
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
    <name>halbench::widgets::MarkerBar</name>
    <message>
        <source>List of markers</source>
        <translation>标记列表</translation>
    </message>
    <message>
        <source>Time of the chosen marker</source>
        <translation>选中标记的时间</translation>
    </message>
    <message>
        <source>Note of the chosen marker</source>
        <translation>选中标记的备注</translation>
    </message>
    <message>
        <source>note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>What is written at the marker; Enter keeps it, Esc leaves it as it was</source>
        <translation>标记处所写的内容；回车键保留，Esc 保持原样</translation>
    </message>
    <message>
        <source>Close the marker&apos;s row</source>
        <translation>关闭标记行</translation>
    </message>
    <message>
        <source>Nothing is chosen any more; the marker stays</source>
        <translation>不再选中；标记保留</translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>%n 个标记</numerusform>
        </translation>
    </message>
    <message>
        <source>All markers by time (Ctrl+J); J chooses the next one</source>
        <translation>按时间列出全部标记（Ctrl+J）；J 选择下一个</translation>
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
    <name>halbench::widgets::NumberWords</name>
    <message>
        <source>&apos;%1&apos; belongs to no number; taken are digits, a sign, &apos;%2&apos; before the decimals and e before a power of ten.</source>
        <translation>“%1”不属于数字；可用：数字、正负号、小数点“%2”和表示十的幂的 e。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; could be misread here: write &apos;%2&apos; before the decimals and nothing between thousands.</source>
        <translation>“%1”在此可能被误读：小数点请写“%2”，千位之间不要写任何符号。</translation>
    </message>
    <message>
        <source>This is not a number.</source>
        <translation>这不是数字。</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::OptionalNumberEdit</name>
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
    <message>
        <source>Allowed: %1.</source>
        <translation>允许：%1。</translation>
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
        <source>old values</source>
        <translation>旧值</translation>
    </message>
    <message>
        <source>Angle ψ %1</source>
        <translation>角度 ψ %1</translation>
    </message>
    <message>
        <source>Coil A
%1
Coil B
%2</source>
        <translation>线圈 A
%1
线圈 B
%2</translation>
    </message>
    <message>
        <source>Hall A
%1
Hall B
%2</source>
        <translation>霍尔 A
%1
霍尔 B
%2</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::ShareSplitter</name>
    <message>
        <source>Drag to share the room; a double click shares it evenly</source>
        <translation>拖动可分配空间；双击则平均分配</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::SpectrogramView</name>
    <message>
        <source>time [s]</source>
        <translation>时间 [s]</translation>
    </message>
    <message>
        <source>frequency [Hz]</source>
        <translation>频率 [Hz]</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Spectrogram</source>
        <translation>频谱图</translation>
    </message>
    <message>
        <source>Nothing to show yet</source>
        <translation>暂无内容</translation>
    </message>
    <message>
        <source>highest %1</source>
        <translation>最大值 %1</translation>
    </message>
    <message>
        <source>%1 s, %2 Hz: %3 %4</source>
        <translation>%1 s，%2 Hz：%3 %4</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StaleWords</name>
    <message>
        <source>No new value since %1 s on the time axis</source>
        <translation>时间轴上自 %1 s 起没有新值</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::StatisticsTable</name>
    <message>
        <source>Signal</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>有效值</translation>
    </message>
    <message>
        <source>Std dev</source>
        <translation>标准差</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值个数</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>间断</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>统计</translation>
    </message>
    <message>
        <source>Copy the table</source>
        <translation>复制表格</translation>
    </message>
    <message>
        <source>Pk-pk</source>
        <translation>峰峰值</translation>
    </message>
    <message>
        <source>Peak to peak: largest less smallest value</source>
        <translation>峰峰值：最大值减最小值</translation>
    </message>
    <message>
        <source>Slope/s</source>
        <translation>斜率/s</translation>
    </message>
    <message>
        <source>From cursor A to B: of the signal&apos;s unit per second</source>
        <translation>从游标 A 到 B：信号单位每秒</translation>
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
        <source>Armed, %1</source>
        <translation>已使能，%1</translation>
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
        <source>STOP</source>
        <translation>停止</translation>
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
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Software stop: current to zero at once, latched until it is released (Esc)</source>
        <translation>软件停止：电流立即归零，并锁存到解除为止（Esc）</translation>
    </message>
    <message>
        <source>Stopped, stop again</source>
        <translation>已停止，再次停止</translation>
    </message>
    <message>
        <source>%1 This and Esc still stop; Release, beside the state, takes the stop back.</source>
        <translation>%1 此按钮和 Esc 仍会停止；状态旁的“解除”可取消停止。</translation>
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
    <message>
        <source>time from the event [s]</source>
        <translation>距事件的时间 [s]</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::UnitMenu</name>
    <message>
        <source>As in the preferences (%1)</source>
        <translation>按首选项（%1）</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>%1 的单位</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::VerdictView</name>
    <message>
        <source>Findings</source>
        <translation>诊断</translation>
    </message>
</context>
<context>
    <name>halbench::widgets::WindowTerms</name>
    <message>
        <source>choose Identify again and enter the given inertia J or the given torque constant φ</source>
        <translation>请选择“重新辨识”，并输入已知的转动惯量 J 或已知的转矩常数 φ</translation>
    </message>
    <message>
        <source>identify the bare motor again and leave the given constants empty</source>
        <translation>请重新辨识空载电机，并将已知常数留空</translation>
    </message>
    <message>
        <source>steady speeds alone do not show the inertia: identify again with run-ups and coast-downs, or enter the given inertia J</source>
        <translation>仅凭稳态转速无法得出转动惯量：请用加速和滑行过程重新辨识，或输入已知的转动惯量 J</translation>
    </message>
    <message>
        <source>enter the bandwidth that is wanted</source>
        <translation>请输入所需的带宽</translation>
    </message>
    <message>
        <source>enter the phase margin that is wanted</source>
        <translation>请输入所需的相位裕度</translation>
    </message>
</context>
</TS>
