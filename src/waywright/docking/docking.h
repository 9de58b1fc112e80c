/* Docking for a vehicle's own program, in C. See docking.hpp for what it does and promises: no files, no threads, no global state, nothing
 * thrown. Metres, seconds, radians; angles counter-clockwise from +x; body frame: x forward (towards the fork tips), y left.
 *
 * Strings and samples that are returned belong to the object that they came from. All functions are safe to call from many threads; one
 * ww_plan or ww_session is used by one thread at a time. */
#ifndef WAYWRIGHT_DOCKING_H
#define WAYWRIGHT_DOCKING_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ww_point {
  double x, y;
} ww_point;

typedef struct ww_pose {
  double x, y, heading;
} ww_pose;

/* A list of corners, or of points. */
typedef struct ww_points {
  const ww_point* first;
  size_t count;
} ww_points;

/* A number of such lists. */
typedef struct ww_polygons {
  const ww_points* first;
  size_t count;
} ww_polygons;

/* Limits of 0 are no limits, but for speed, reverse_speed, acceleration and deceleration, which must be above 0. */
typedef struct ww_vehicle {
  ww_points footprint;      /* simple polygon in the body frame */
  ww_polygons forks;        /* parts of it that may enter a pocket; may be empty */
  double wheelbase;         /* of a tricycle; 0: a differential drive */
  double max_steering;      /* rad, in (0, pi/2), of a tricycle */
  double max_steering_rate; /* rad/s */
  int front_steered;        /* 1: the steered axle is in front of the fixed one (a car); 0: behind it */
  double speed, reverse_speed, acceleration, deceleration;
  double lateral_acceleration, angular_speed, curvature, curvature_rate;
} ww_vehicle;

typedef struct ww_station {
  ww_points area;                            /* the vehicle stays inside; shelf and obstacles are in it */
  ww_point shelf_center;
  double shelf_heading;                      /* where its loading face looks */
  double shelf_depth, shelf_width;
  double gap;                                /* fork tips to face when docked */
  double slot;                               /* body axis along the face from its middle, left of the shelf's heading positive */
  double insertion_depth;                    /* fork tips behind the face at the end; 0: the path ends docked */
  const double (*pockets)[2];                /* openings in the face, right and left end of each; with insertion_depth */
  size_t pocket_count;
  ww_polygons obstacles;
  ww_polygons lines;                         /* open walls */
  ww_points points;                          /* scan points */
} ww_station;

typedef struct ww_request {
  ww_vehicle vehicle;
  ww_station station;
  ww_pose start;
  double start_speed;                                                 /* along the heading, backwards negative; 0: the vehicle stands */
  double start_curvature;                                             /* of its way, in the direction of travel; where it moves */
  double clearance;                                                   /* kept by the whole footprint */
  double lateral_error, longitudinal_error, heading_error;            /* the proof holds for every pose within these */
  int64_t evaluations;                                                /* candidates a side; 0: the default of 600 */
} ww_request;

typedef enum ww_status {
  WW_SOLVED = 0,
  WW_UNPROVEN,
  WW_NO_PATH,
  WW_START_IN_COLLISION,
  WW_GOAL_IN_COLLISION,
  WW_START_OUTSIDE,
  WW_GOAL_OUTSIDE,
  WW_TIMED_OUT,
  WW_CANCELED,
  WW_BAD_INPUT
} ww_status;

/* Where a vehicle is on a plan. */
typedef struct ww_state {
  double driven; /* m so far */
  ww_pose pose;
  double speed;     /* as start_speed */
  double curvature; /* as start_curvature */
} ww_state;

/* A row of the path: where the direction changes a pose stands twice. */
typedef struct ww_sample {
  double s, x, y, heading, curvature, t, speed;
  int direction; /* 1 forwards, -1 backwards */
} ww_sample;

typedef struct ww_docking ww_docking;
typedef struct ww_plan ww_plan;

/* What is pointed to by the request is copied. NULL where it cannot be used: then `message`, if not NULL, holds one sentence, cut to `size`
 * bytes with its end. */
ww_docking* ww_docking_prepare(const ww_request* request, char* message, size_t size);
/* The same station from where the vehicle is now, its shelf with this centre and heading (NULL: where it was), prepared anew. */
ww_docking* ww_docking_from(const ww_docking* docking, const ww_state* now, const ww_pose* shelf, char* message, size_t size);
void ww_docking_free(ww_docking* docking);

/* A flag that another thread raises to end a plan: it ends within some microseconds. */
typedef struct ww_cancel ww_cancel;
ww_cancel* ww_cancel_create(void);
void ww_cancel_raise(ww_cancel* cancel);
void ww_cancel_free(ww_cancel* cancel);

/* Plans; ended after `seconds` (0: no limit) or by `cancel` (NULL: never): then the best path so far, if there is one. NULL only where there
 * is no memory. */
ww_plan* ww_docking_plan(const ww_docking* docking, double seconds, const ww_cancel* cancel);
void ww_plan_free(ww_plan* plan);

/* Plans one after another in memory that it keeps: nothing is asked of the system while planning. The docking outlives it; what is returned
 * is the session's, until its next plan. NULL only where there is no memory, or no session. */
typedef struct ww_session ww_session;
ww_session* ww_session_create(const ww_docking* docking);
void ww_session_free(ww_session* session);
const ww_plan* ww_session_plan(ww_session* session, double seconds, const ww_cancel* cancel);
/* With the forks in the shelf nothing is planned anew (WW_START_IN_COLLISION). Otherwise: what is left of `old` after `driven` metres, carried along with start and shelf where that is proven, else planned anew: for a session on
 * what ww_docking_from gave. */
const ww_plan* ww_session_replan(ww_session* session, const ww_plan* old, double driven, double seconds, const ww_cancel* cancel);

ww_status ww_plan_status(const ww_plan* plan);
const char* ww_plan_reason(const ww_plan* plan); /* "" where solved */
double ww_plan_clearance(const ww_plan* plan);   /* proven over the whole motion, pose error taken off; m */
double ww_plan_length(const ww_plan* plan);
double ww_plan_time(const ww_plan* plan);
double ww_plan_cost(const ww_plan* plan);
int ww_plan_is_carried_on(const ww_plan* plan); /* 1: what was left of another plan, and no place of it farther off than … */
double ww_plan_moved(const ww_plan* plan);      /* … this; m */
ww_state ww_plan_state(const ww_plan* plan, double time); /* after so many seconds; zeros where there is no path */
const ww_sample* ww_plan_samples(const ww_plan* plan, size_t* count);

#ifdef __cplusplus
}
#endif
#endif
