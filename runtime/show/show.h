#pragma once
// Your own control loop in the page of `treeline drive --robot controller:HOST:PORT`: it shows what
// your robot does, and gets the goals, Start and STOP of the page. C99 and C++17, POSIX sockets; no
// function waits or allocates.
//
//     TreelineShow show;
//     if (treeline_show_open(&show, "127.0.0.1", 7000, 6, 6, "") != 0) perror("show");
//     for (;;) {                                    // your loop, at any rate
//       const int enabled = treeline_show_receive(&show);
//       ...                                         // go to show.q, or brake unless enabled
//       treeline_show_value(&show, "error", error); // plotted beside the joints
//       treeline_show_send(&show, q, qd, tau);
//     }

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include "show/packet.h"

/// What the page wants, and how it is reached. Coordinates and velocities are in the order and the
/// units of the generated code. Read its first part alone, and copy none of it.
typedef struct TreelineShow {
  int enabled;           ///< 1: go to the goals. 0: brake; after STOP or a fault, or in silence
  int mode;              ///< 0 idle, 1 running, 2 stopping, 3 faulted
  int control;           ///< goals are of 0 the joints, 1 the points, 2 nothing: be led by hand
  const double *q, *qd;  ///< goals of the joints, nq and nv numbers
  const double* points;  ///< goals of the points: x y z qx qy qz qw of each, in the world
  int point_count;

  int socket, nq, nv, named;
  double heard, led;  ///< s: when somebody asked, and when goals came; 0: never
  struct sockaddr_in peer;
  uint64_t robot, run, newest, sent;
  TreelinePacketSeal seal;
  double goal[treeline_packet_numbers], came[treeline_packet_numbers];
  double motion[treeline_packet_numbers];
  unsigned char bytes[treeline_packet_size];
} TreelineShow;

static inline double treeline_show_time(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/// Listens at an address of this machine, a number, for the robot of `nq` coordinates and `nv`
/// velocities. Who does not prove to know `secret` is not heard; "" proves nothing. Returns 0, or
/// -1 with `errno`.
static inline int treeline_show_open(TreelineShow* show, const char* host, int port, int nq, int nv,
                                     const char* secret) {
  struct timespec now;
  memset(show, 0, sizeof(*show));
  show->socket = -1;
  show->nq = nq;
  show->nv = nv;
  show->q = show->goal + 2;
  show->qd = show->q + nq;
  show->points = show->qd + nv;
  clock_gettime(CLOCK_REALTIME, &now);
  show->run = (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
  treeline_seal_begin(&show->seal, secret);
  show->peer.sin_family = AF_INET;
  show->peer.sin_port = htons((uint16_t)port);
  errno = EINVAL;
  if (nq + 2 * nv + 3 * treeline_named_numbers > treeline_packet_numbers ||
      inet_pton(AF_INET, host, &show->peer.sin_addr) != 1) {
    return -1;
  }
  show->socket = socket(AF_INET, SOCK_DGRAM, 0);
  return show->socket < 0 ? -1
                          : bind(show->socket, (struct sockaddr*)&show->peer, sizeof(show->peer));
}

/// Whether `count` numbers that have come are goals for this robot.
static inline int treeline_show_is_goal(const TreelineShow* show, size_t count) {
  const size_t joints = 2 + (size_t)show->nq + (size_t)show->nv;
  return count >= joints && (count - joints) % 7 == 0 && show->came[0] >= 0 && show->came[0] <= 3 &&
         show->came[1] >= 0 && show->came[1] <= 2;
}

/// Obeys a packet of a drive that may lead: the one that does, or, after a silence of 1 s, another.
/// None is obeyed again: numbers grow, and goals repeat `run`.
static inline void treeline_show_take(TreelineShow* show, const TreelinePacketHead* head,
                                      const struct sockaddr_in* from, size_t count) {
  const double now = treeline_show_time();
  const int is_peer =
      from->sin_port == show->peer.sin_port && from->sin_addr.s_addr == show->peer.sin_addr.s_addr;
  const int is_goal = head->kind == treeline_packet_goal && head->run == show->run;
  const int is_request = head->kind == treeline_packet_request && count == 0;
  if (!is_goal && !is_request) return;
  if (!is_peer && show->led > 0 && now - show->led < 1.0) return;
  if ((is_peer || show->seal.is_wanted) && head->sequence <= show->newest) return;
  if (is_goal && !treeline_show_is_goal(show, count)) return;
  show->peer = *from;
  show->robot = head->robot;
  show->newest = head->sequence;
  show->heard = now;
  if (is_request) return;
  memcpy(show->goal, show->came, 8 * count);
  show->mode = (int)show->goal[0];
  show->control = (int)show->goal[1];
  show->point_count = ((int)count - 2 - show->nq - show->nv) / 7;
  show->led = now;
}

/// Takes what has come, and returns `enabled`. Who is silent for 0.1 s no longer enables anything.
static inline int treeline_show_receive(TreelineShow* show) {
  for (int i = 0; i < 64; ++i) {  // a flood is not to hold your loop
    struct sockaddr_in from;
    socklen_t length = sizeof(from);
    TreelinePacketHead head;
    const ssize_t came = recvfrom(show->socket, show->bytes, sizeof(show->bytes), MSG_DONTWAIT,
                                  (struct sockaddr*)&from, &length);
    if (came < 0) break;
    const size_t size = treeline_seal_open(&show->seal, show->bytes, (size_t)came);
    const size_t count = treeline_packet_count(size);
    if (count <= treeline_packet_numbers &&
        treeline_packet_read(show->bytes, size, count, &head, show->came)) {
      treeline_show_take(show, &head, &from, count);
    }
  }
  show->enabled = show->mode == 1 && treeline_show_time() - show->led < 0.1;
  return show->enabled;
}

/// Shows a number by a name of at most 16 bytes, at most 16 of them, with the next motion.
static inline void treeline_show_value(TreelineShow* show, const char* name, double value) {
  double* const to = show->motion + show->nq + 2 * show->nv + 3 * show->named;
  if (show->named == treeline_named_numbers) return;
  treeline_packet_write_name(name, to);
  to[2] = value;
  ++show->named;
}

/// Shows a motion: positions and velocities of the joints, and their torques or forces. Nobody is
/// sent anything who has not asked within the last second.
static inline void treeline_show_send(TreelineShow* show, const double* q, const double* qd,
                                      const double* tau) {
  const size_t nq = (size_t)show->nq;
  const size_t nv = (size_t)show->nv;
  const TreelinePacketHead head = {treeline_packet_motion, show->robot, ++show->sent, show->newest,
                                   show->run};
  const size_t count = nq + 2 * nv + 3 * (size_t)show->named;
  show->named = 0;
  if (show->heard == 0 || treeline_show_time() - show->heard > 1.0) return;
  memcpy(show->motion, q, 8 * nq);
  memcpy(show->motion + nq, qd, 8 * nv);
  memcpy(show->motion + nq + nv, tau, 8 * nv);
  const size_t size = treeline_seal_close(
      &show->seal, show->bytes, treeline_packet_write(&head, show->motion, count, show->bytes));
  (void)sendto(show->socket, show->bytes, size, MSG_DONTWAIT, (struct sockaddr*)&show->peer,
               sizeof(show->peer));  // the next one follows a lost one
}

static inline void treeline_show_close(TreelineShow* show) {
  if (show->socket >= 0) close(show->socket);
  show->socket = -1;
}
