# SPDX-License-Identifier: MIT
# The portable sources, compiled for every board and natively; relative to firmware/ and protocol/.
set(ECHOMAP_FIRMWARE_SOURCES
  drivers/analog_inputs.cpp drivers/debounced_bits.cpp drivers/gyro_angle.cpp drivers/gyro_mpu6050.cpp
  drivers/motor_bridge.cpp drivers/pan_drive.cpp drivers/pan_servo.cpp drivers/pan_stepper.cpp drivers/range_sonar.cpp
  drivers/scalar_sensor.cpp drivers/serial_port.cpp drivers/sonar_hc_sr04.cpp drivers/spare_pins.cpp
  drivers/wheel_encoders.cpp
  control/distance_ramp.cpp control/driven_wheel.cpp control/proportion.cpp control/scan_sweep.cpp
  control/speed_ramp.cpp control/wheel_guard.cpp control/wheel_motion.cpp
  control/wheel_speed_controller.cpp
  tasks/bulk.cpp tasks/command.cpp tasks/frame_sender.cpp tasks/heartbeat.cpp
  tasks/line_budget.cpp tasks/safety.cpp tasks/scheduler.cpp tasks/sensors.cpp
  tasks/telemetry.cpp
  app/events.cpp app/robot.cpp)
set(ECHOMAP_PROTOCOL_SOURCES cobs.cpp configuration.cpp frame_decoder.cpp frame_encoder.cpp link.cpp
  schema_reader.cpp)
