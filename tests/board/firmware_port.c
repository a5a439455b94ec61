// A port of `--package firmware` for this machine: drives and a front end that speak the frames as
// can.h describes them. The first argument is what happens, and each line that is printed what came
// of it. The interrupt comes while the main loop sleeps, and amid its reading of the status.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "port.h"

enum { LAST_TICK = 290, ENDLESS = 100000 };

static const char* event;
static void (*on_tick)(void);
static uint32_t ticks, received, most_received, asked;
static int in_tick, torn, brake, mode = -1;
static float wheel = 3000.0F, torque[2];
static uint32_t faults, refused;

static int happens(const char* what) {
  return strcmp(event, what) == 0;
}

static void finish(void) {
  printf("mode %d\nfaults %u\nbrake %d\nrefused %u\ntorn %d\n", mode, faults, brake, refused, torn);
  printf("frames a step %u\nwheel %.9g\nlift %.9g\n", most_received, (double)torque[0],
         (double)torque[1]);
  exit(0);
}

static void interrupt(void) {
  if (++ticks > LAST_TICK) finish();
  received = 0;
  in_tick = 1;
  on_tick();
  in_tick = 0;
}

void port_begin(void (*tick)(void), uint32_t rate) {
  (void)rate;
  on_tick = tick;
}

uint32_t port_microseconds(void) {
  return 1000 * ticks;
}
void port_kick_watchdog(void) {}
void port_wait(void) {
  interrupt();
}
void port_brake(int32_t closed) {
  brake = closed;
}

static void put(struct can_frame* frame, uint32_t id, float first, float second) {
  frame->id = id;
  frame->length = 8;
  memcpy(&frame->data[0], &first, 4);
  memcpy(&frame->data[4], &second, 4);
}

// The drives: one frame each, or without end that of the wheel.
static int measure(struct can_frame* frame) {
  const int floods = happens("flood") && ticks > 200;
  const float q = ticks > 200 && happens("nan")        ? NAN
                  : ticks > 200 && happens("infinite") ? INFINITY
                  : ticks > 200 && happens("far")      ? 1e30F
                                                       : wheel;
  const uint32_t joint = floods ? 0 : received;
  if (joint == 2) return 0;
  if (++received > ENDLESS) {
    printf("endless\n");
    exit(1);
  }
  if (received > most_received) most_received = received;
  put(frame, 0x100 + joint, joint == 0 ? q : 0.5F, 0.0F);
  return 1;
}

// The front end: start, then a motion of the wheel for as long, to there.
static int command(struct can_frame* frame) {
  const float length = happens("no duration") ? NAN : happens("long") ? 100.0F : 0.5F;
  const float goal = happens("far goal") ? 1e30F : happens("no goal") ? NAN : wheel + 0.2F;
  const int step = ticks < 100 ? 0 : (int)asked;
  if (ticks < 100 || asked == 4) return 0;
  ++asked;
  if (step == 1 || step == 2) {
    put(frame, 0x310U + (uint32_t)step - 1U, step == 1 ? goal : 0.5F, 0.0F);
    frame->length = 4;
  } else {
    put(frame, 0x300, 0.0F, step == 0 ? 0.0F : length);
    frame->data[0] = step == 0 ? 4 : 6;  // START, MOVE_JOINTS
  }
  return 1;
}

int port_receive(int bus, struct can_frame* frame) {
  return bus == PORT_DRIVES ? measure(frame) : command(frame);
}

void port_send(int bus, const struct can_frame* frame) {
  if (bus == PORT_DRIVES) {
    memcpy(&torque[frame->id - 0x200], frame->data, 4);
    if (frame->length != 4 || !isfinite(torque[frame->id - 0x200])) printf("not a torque\n");
    return;
  }
  mode = frame->data[0];
  if (frame->data[2] != 0) refused = frame->data[2];
  memcpy(&faults, &frame->data[4], 4);
}

void __real_can_write_status(const void* output, struct can_frame* frame);

// What is read of the output twice has to be the same.
void __wrap_can_write_status(const box_output* output, struct can_frame* frame) {
  const int32_t before = output->mode;
  if (!in_tick) interrupt();
  if (output->mode != before) torn = 1;
  __real_can_write_status(output, frame);
}

int firmware_main(void);

int main(int count, char** arguments) {
  event = count > 1 ? arguments[1] : "";
  return firmware_main();
}
